// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "crowding.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

// A check whether the spacing in the settings and the volumes of particles fit the distances between them.
namespace scree {

/// The packing of the material: medians over its particles that are surrounded by others.
struct Packing {
  long particles = 0;      ///< of the material
  long full = 0;           ///< number of particles of the material that are surrounded by others
  double density = 1;      ///< median of sum V W over the `full` particles, at most 4; 1 if there are none
  double loose = 1;        ///< 5 % quantile of sum V W over the `full` particles
  double dense = 1;        ///< 95 % quantile of sum V W over the `full` particles, at most 4
  double by_number = 1;    ///< median of sum W spacing^dim over the `full` particles, at most 4; 1 if there are none
  double nearest = 1;      ///< median over all particles of nearest-neighbour distance over spacing, at most 4
  double volume = 1;       ///< median over all particles of volume over spacing^dim, at most 4
  long at_walls = 0;       ///< number of particles that touch walls and have neighbours on all other sides
  long facing = 0;         ///< number of particles that have walls on the side that the material leaves empty
  long facing_little = 0;  ///< number of `facing` particles with less than 0.6 of the wall that fills that side
  long facing_sparse = 0;  ///< number of those within 2 spacings of a wall particle that fills < 0.4 of its space
  double walls = 1;  ///< median at walls of sum V W over walls, relative to what the material leaves of 1, at most 4
  double fill_of_walls = 1;  ///< median over wall particles of volume over the dim-th power of the distance to
                             ///< the nearest other wall particle (at most 3 spacings), at most 4

  /// Whether the spacing and the volumes may be those of the particles at a start. If some particles are surrounded by
  /// others, the median of sum V W must lie between 0.95 and 1.05: it is 1.003 to 1.006 on lattices and rings, at most
  /// 1.03 with a normally distributed jitter of 0.2 spacings along each axis, at most 1.024 with a uniform jitter of up
  /// to 0.3 spacings, and 0.985 in layers of two rows on a wall or of four rows without one. A spacing that is wrong by
  /// 2.5 % (in the plane) or by 1.7 % (in space) changes the median by 5 %. Volumes may differ from spacing^dim by up
  /// to a quarter if the positions alone fit the spacing: this occurs in fillings with a given mass. In layers of few
  /// rows on a lattice along a slope, where less than half of the particles are surrounded by others, the steps of the
  /// surface lower `by_number` to 0.92: 0.9 to 1.05 is then allowed if the median distance of nearest neighbours is
  /// within 1 % of the spacing. Thinner layers, where less than one particle in twenty is surrounded by others, are
  /// judged by the distance of nearest neighbours: 1 on a square lattice, 1.12 in close packing, 0.73 with jitter; 0.7
  /// to 1.2 is allowed, if the median of the volumes is within a quarter of spacing^dim.
  bool may_start() const {
    if (is_thin()) return is_near_enough() && fits(volume, 0.25);
    return fits(density, 0.05) || ((fits(by_number, 0.05) || is_stepped()) && fits(density, 0.25));
  }
  /// Whether the spacing and the volumes of walls may be right. They matter because the material feels the stress in a
  /// wall in proportion to the space that the wall fills. `walls` is 1.02 on a lattice and 0.94 to 1.08 with a jitter
  /// of 0.3 spacings. In the plane, a wall spacing that is 5 % too small or too large gives 1.14 or 0.92. A gap of 0.1
  /// spacings gives 0.86 and an overlap of 0.2 spacings gives 1.4, although the wall is correct; this is why
  /// `fill_of_walls` is also considered, which is 1 on a square lattice and 0.87 on a hexagonal one. Walls are wrong if
  /// both values are above 1.15, or both are below 0.85, or if walls_are_sparse().
  bool walls_may_start() const {
    if (walls_are_sparse()) return false;
    return at_walls < 8 || !((walls > 1.15 && fill_of_walls > 1.15) || (walls < 0.85 && fill_of_walls < 0.85));
  }
  /// Whether walls are so sparse that they may not be on all sides of the material beside them: 8 particles or more
  /// face walls, most of these have less than 0.6 of the volume of walls that fills their empty side, and
  /// `fill_of_walls` is below 0.4. `fill_of_walls` is 0.25 (in space 0.12) if the spacing of the walls is twice the
  /// right one, and 0.69 or more on lattices of the right spacing.
  bool walls_are_sparse() const {
    return facing >= 8 && 2 * facing_little > facing && fill_of_walls < detail::Crowding::sparse_fill;
  }
  /// Whether one of several walls may be too sparse, which a median over all walls does not show: 8 particles of the
  /// material or more are beside it. Grates and pins of single particles look the same.
  bool a_wall_is_sparse() const { return facing_sparse >= 8; }
  /// Whether particles are on a lattice of their spacing, in a layer whose surface has steps.
  bool is_stepped() const {
    return 2 * full < particles && fits(nearest, 0.01) && by_number >= 0.9 && by_number <= 1.05;
  }
  /// Whether too few particles are surrounded by others: less than one in twenty.
  bool is_thin() const { return full == 0 || 20 * full < particles; }
  /// Whether there are enough particles to judge the packing.
  bool can_tell() const { return full > 0 || particles >= 30; }
  /// Whether loaded grains fill approximately the space that they had at a start: the median of sum V W, with their
  /// volumes or with spacing^dim, lies between 0.85 and 1.1. One of the two values is enough, because volumes may
  /// differ by a quarter from spacing^dim at a start, see may_start(). Both values lie between 0.95 and 1.05 in beds
  /// and flows whose pressure follows the packing.
  bool keeps_volume() const { return full < 30 || is_usual(density) || is_usual(by_number); }
  /// Whether nearest neighbours are 0.7 to 1.2 spacings apart.
  bool is_near_enough() const { return nearest >= 0.7 && nearest <= 1.2; }
  /// Returns the deviation of the volumes from those that fill the space, as a fraction.
  double misfit() const { return std::abs((is_thin() ? volume : density) - 1); }
  /// Returns `density`, `loose`, `dense` and `full` as a text, such as "1.003, 0.98 to 1.02 in 412 grains".
  [[gnu::cold]] std::string text() const;
  /// Whether a median differs from 1 by at most `bar`.
  static bool fits(double median, double bar) { return std::abs(median - 1) <= bar; }
  /// Whether a median is between 0.85 and 1.1.
  static bool is_usual(double median) { return median >= 0.85 && median <= 1.1; }
};

namespace detail {

/// Returns a quantile by bisection, at most 4: the smallest number that at least `twentieths`/20 of some values do not
/// exceed; 10 gives the lower median. count(x) returns how many of the `members` values are at most x.
[[gnu::cold]] double quantile(std::function<long(double)> const& count, long members, int twentieths = 10);

/// The packing around particles, collected for medians.
class PackingOfMany {
 public:
  void add(Crowding const& at, double spacing);
  /// Adds the volume of a wall particle, divided by the space that it has.
  void add_wall(double fill) { fill_of_walls_.push_back(fill); }
  /// Adds that a particle that faces too little of a wall has a nearest particle of it with this volume over the space
  /// that it has.
  void add_facing(double fill) { facing_sparse_ += fill < Crowding::sparse_fill; }
  [[gnu::cold]] void add(PackingOfMany const& other);
  /// Returns the medians over all ranks of the case, which call this function together; `sum` adds up over the ranks.
  [[gnu::cold]] Packing of_all(std::function<long(long)> const& sum) const;

 private:
  /// Returns a quantile of the values on all ranks, in twentieths; the median by default.
  [[gnu::cold]] static double quantile(std::vector<double> const& values, std::function<long(long)> const& sum,
                                       int twentieths = 10);

  std::vector<double> nearest_, volume_, density_, by_number_, walls_, fill_of_walls_;
  long facing_ = 0, facing_little_ = 0, facing_sparse_ = 0;
};

}  // namespace detail

/// Returns the message, which begins with `where`, about a fault in the packing of particles with a spacing (m) in 2 or
/// 3 dimensions; "" if there is no fault.
[[gnu::cold]] std::string fault_of_packing(Packing const& packing, double spacing, int dimensions,
                                           std::string const& where);

/// Returns the message, which begins with `where`, about a fault in the packing of walls with a spacing (m); "" if
/// there is no fault.
[[gnu::cold]] std::string fault_of_walls(Packing const& packing, double spacing, std::string const& where);

/// Returns the warning about one wall that may be too sparse for a spacing (m); "" if there is none.
[[gnu::cold]] std::string warning_of_sparse_wall(Packing const& packing, double spacing);

}  // namespace scree

#ifndef SCREE_COMPILED
#include "packing.ipp"
#endif
