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

// Whether the spacing in the settings and the volumes of particles fit the distances between them.
namespace scree {

/// The packing of the material: medians over its particles that have others on all sides.
struct Packing {
  long particles = 0;      ///< of the material
  long full = 0;           ///< how many of them have others on all sides
  double density = 1;      ///< median of sum V W, at most 4; 1 without any
  double loose = 1;        ///< sum V W that one in twenty of them has at most
  double dense = 1;        ///< sum V W that one in twenty of them exceeds, at most 4
  double by_number = 1;    ///< median of the same sum with the volume spacing^dim, at most 4; 1 without any
  double nearest = 1;      ///< median distance of nearest neighbours over the spacing, over all particles, at most 4
  double volume = 1;       ///< median of the volumes over spacing^dim, over all particles, at most 4
  long at_walls = 0;       ///< number of particles that touch walls and have neighbours on all other sides
  long facing = 0;         ///< number of particles that have walls on the side that the material leaves empty
  long facing_little = 0;  ///< how many of these see less than 0.6 of the volume of walls that belongs there
  long facing_sparse = 0;  ///< and are within 2 spacings of a particle of a wall that fills less than 0.4 of its space
  double walls = 1;  ///< median over them of sum V W over walls, over what the material leaves of 1 to them, at most 4
  double fill_of_walls = 1;  ///< median of the volumes of walls over the dim-th power of the distance of the nearest
                             ///< other particle of a wall (at most 3 spacings), at most 4

  /// Whether the spacing and the volumes may be those of the particles at a start. Where some particles have others on
  /// all sides, the median of sum V W is from 0.95 to 1.05: it is 1.003 to 1.006 on lattices and rings, at most 1.03 if
  /// they are jittered by normal numbers of 0.2 spacings along each axis, 1.024 by uniform ones of up to 0.3, and
  /// 0.985 in layers of two rows on a wall or four free ones. A spacing that is wrong by 2.5 % (in the plane) or by
  /// 1.7 % (in space) moves it by 5 %. Other volumes, up to a quarter away, are allowed if positions alone fit the
  /// spacing: fillings with a given mass have them. In layers of few rows on a lattice along a slope, where less than
  /// half of the particles have others on all sides, the steps of the surface lower the median by number to 0.92: 0.9
  /// to 1.05 is allowed, if nearest neighbours are one spacing away to 1 %. Thinner layers, where less than one
  /// particle in twenty has others on all sides, are judged by the distance of nearest neighbours: 1 on a square
  /// lattice, 1.12 in close packing, 0.73 with jitter; from 0.7 to 1.2 is allowed, with volumes up to a quarter away.
  bool may_start() const {
    if (is_thin()) return is_near_enough() && fits(volume, 0.25);
    return fits(density, 0.05) || ((fits(by_number, 0.05) || is_stepped()) && fits(density, 0.25));
  }
  /// Whether the spacing and the volumes of walls may be right: the material feels as much of the stress in a wall as
  /// the wall fills. `walls` is 1.02 on a lattice and 0.94 to 1.08 with jitter of 0.3 spacings. In the plane a wall
  /// spacing that is 5 % too small or too large gives 1.14 or 0.92. A gap of 0.1 spacings gives 0.86 and an overlap of
  /// 0.2 spacings gives 1.4, although the wall is correct; `fill_of_walls` then shows it: 1 on a square lattice, 0.87
  /// on a hexagonal one. It is enough if one of the two is from 0.85 to 1.15.
  bool walls_may_start() const {
    if (walls_are_sparse() || a_wall_is_sparse()) return false;
    return at_walls < 8 || !((walls > 1.15 && fill_of_walls > 1.15) || (walls < 0.85 && fill_of_walls < 0.85));
  }
  /// Whether walls are so sparse that they may not be on all sides of the material beside them: most particles that
  /// face them, of 8 or more, see less than 0.6 of what belongs there, and the particles of walls fill less than 0.4 of
  /// their own space. The last is 0.25 (in space 0.12) with twice the spacing, and 0.69 or more on lattices of the
  /// right one.
  bool walls_are_sparse() const {
    return facing >= 8 && 2 * facing_little > facing && fill_of_walls < detail::Crowding::sparse_fill;
  }
  /// Whether one of several walls is so sparse, which a median over all of them does not show: it is so beside 8
  /// particles of the material.
  bool a_wall_is_sparse() const { return facing_sparse >= 8; }
  /// Whether particles are on a lattice of their spacing, in a layer whose surface has steps.
  bool is_stepped() const {
    return 2 * full < particles && fits(nearest, 0.01) && by_number >= 0.9 && by_number <= 1.05;
  }
  /// Whether too few particles have others on all sides: less than one in twenty.
  bool is_thin() const { return full == 0 || 20 * full < particles; }
  /// Whether there are enough particles for a judgement.
  bool can_tell() const { return full > 0 || particles >= 30; }
  /// Whether loaded grains fill about the space that they had at a start: the median of sum V W over them, with their
  /// volumes or with spacing^dim, is from 0.85 to 1.1. The second counts because volumes may start a quarter away from
  /// their space, see may_start(). Both are from 0.95 to 1.05 in beds and flows whose pressure follows the packing.
  bool keeps_volume() const { return full < 30 || is_usual(density) || is_usual(by_number); }
  /// Whether nearest neighbours are 0.7 to 1.2 spacings apart.
  bool is_near_enough() const { return nearest >= 0.7 && nearest <= 1.2; }
  /// The deviation of the volumes from filling the space.
  double misfit() const { return std::abs((is_thin() ? volume : density) - 1); }
  /// "1.003, 0.98 to 1.02 in 412 grains": `density`, `loose` and `dense` over the `full` ones.
  [[gnu::cold]] std::string text() const;
  /// Whether a median differs from 1 by at most `bar`.
  static bool fits(double median, double bar) { return std::abs(median - 1) <= bar; }
  /// Whether a median is from 0.85 to 1.1.
  static bool is_usual(double median) { return median >= 0.85 && median <= 1.1; }
};

namespace detail {

/// The smallest value that at least a number of twentieths of some values do not exceed, 10 for the lower median; by
/// bisection, at most 4. `count(x)` of the `members` values are at most x.
[[gnu::cold]] double quantile(std::function<long(double)> const& count, long members, int twentieths = 10);

/// Collects the packing around particles.
class PackingOfMany {
 public:
  void add(Crowding const& at, double spacing);
  /// Adds the volume of a particle of a wall over the space that it has.
  void add_wall(double fill) { fill_of_walls_.push_back(fill); }
  /// Adds that a particle that faces too little of a wall has a nearest particle of it with this volume over the space
  /// that it has.
  void add_facing(double fill) { facing_sparse_ += fill < Crowding::sparse_fill; }
  [[gnu::cold]] void add(PackingOfMany const& other);
  /// The medians over all ranks of the case, which call it together; `sum` is over these.
  [[gnu::cold]] Packing of_all(std::function<long(long)> const& sum) const;

 private:
  /// A quantile of the values of all ranks, the median unless twentieths are given.
  [[gnu::cold]] static double quantile(std::vector<double> const& values, std::function<long(long)> const& sum,
                                       int twentieths = 10);

  std::vector<double> nearest_, volume_, density_, by_number_, walls_, fill_of_walls_;
  long facing_ = 0, facing_little_ = 0, facing_sparse_ = 0;
};

}  // namespace detail

/// The message about a fault in the packing of particles of a spacing (m) in 2 or 3 dimensions, which begins with
/// `where`; "" if there is none.
[[gnu::cold]] std::string fault_of_packing(Packing const& packing, double spacing, int dimensions,
                                           std::string const& where);

/// The message about a fault in the packing of walls of a spacing (m), which begins with `where`; "" if there is none.
[[gnu::cold]] std::string fault_of_walls(Packing const& packing, double spacing, std::string const& where);

}  // namespace scree

#ifndef SCREE_COMPILED
#include "packing.ipp"
#endif
