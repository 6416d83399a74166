// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../boundaries/on_plate.hpp"
#include "../fields/bodies.hpp"
#include "../fields/whole_body.hpp"
#include "start.hpp"
#include "wall_view.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

// Finds walls that are too thin for the support of the kernel. It runs on the host and does not depend on the
// formulation.
namespace scree {

/// The particles of the material, `owned` of them, then those of walls, which of the latter belong to plates and which
/// of these turn; of the whole case, or those that are here and near these.
struct ParticlesAtWalls {
  PlacedParticles all;
  std::size_t owned = 0;
  std::vector<char> is_plate;
  std::vector<char> turns;                                          ///< empty: none
  double support = detail::WallView::usual_support;                 ///< of the kernel, spacings
  std::size_t looked_at = std::numeric_limits<std::size_t>::max();  ///< later particles of walls are not here

  /// Inserts the particles of the material before those of walls. They need names if the particles of walls have names.
  /// Call it once.
  [[gnu::cold]] void put_material(PlacedParticles const& material);
  /// Adds the particles of a wall, of a scheme that shows means of the material except on plates
  /// (boundaries/plates.hpp) or that makes all walls like plates; and which of them turn, unless that is empty.
  template <class... Of>
  [[gnu::cold]] void add_wall(WholeBody<Of...> const& body, bool shows_means, std::vector<char> const& turning = {}) {
    all.add_part(body);
    if constexpr (OneOf<OnPlate, typename WholeBody<Of...>::particles::fields>)
      add_plates(body.all_here() ? body.values(OnPlate{}) : body.here().to_host(OnPlate{}), shows_means);
    is_plate.resize(all.places.size() - owned, !shows_means);
    if (!turning.empty())
      for (char const each : body.all_here() ? body.order().of(turning) : turning) turns.push_back(each != 0);
    turns.resize(is_plate.size(), false);
    looked_at = is_plate.size();
  }
  /// Adds copies of particles of a wall that are elsewhere, within `reach` (m) of the particles here. Call it after
  /// add_wall() of all walls.
  template <class Body, class Sys>
  [[gnu::cold]] void add_wall_near(Sys const& system, double reach, bool shows_means) {
    using Given = typename std::remove_cvref_t<decltype(system.template body<Body>())>::fields;
    using Wanted = Merge<Fields<Position, Volume, Identity>, Common<Fields<OnPlate>, Given>>;
    system.template with_copies_near<Body>(reach, false, Wanted{}, [&](auto const& copies) {
      all.add_here(copies);
      if constexpr (OneOf<OnPlate, Given>) add_plates(copies.to_host(OnPlate{}), shows_means);
      is_plate.resize(all.places.size() - owned, !shows_means);
      turns.resize(is_plate.size(), false);
    });
  }

 private:
  template <class Values>
  void add_plates(Values const& values, bool shows_means) {
    for (auto const on : values) is_plate.push_back(on > 0 || !shows_means);
  }
};

/// Looks for walls that are too thin:
///   a wall with material on both sides, of which one of its particles shows each side a mean with a share of the other
///     above 5 %; walls of 4 spacings stay below
///   a plate of less than 1.75 spacings with material on both sides, which then act on each other; at the start,
///     of less than 2.5 if it turns: grains press closer to its rows than half a spacing, which a plate of two does not
///     bear
///   a wall of one row of particles with material in front
/// Edges, bodies of a few spacings with material all around and the feet of plates are not checked, and periods are not
/// followed. The threads of the host share the walls; of the particles with a fault the one with the lowest number is
/// named.
class ThinWalls {
 public:
  /// Used in place of the number of a particle where there is none.
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  /// Examines the particles at walls of a spacing (m) in 2 or 3 dimensions.
  [[gnu::cold]] ThinWalls(ParticlesAtWalls const& particles, double spacing, int dimensions);
  /// The number of wall particles with a fault.
  std::size_t faults() const { return found_.faults; }
  /// The lowest number of a wall particle with a fault; `none` if there is none.
  std::size_t lowest() const { return found_.lowest; }
  /// Returns a description of the fault of the particle lowest().
  [[gnu::cold]] std::string text() const;

 private:
  detail::ThinWall fault(detail::WallView const& view, std::size_t w) const;
  struct Found {
    std::size_t faults = 0, lowest = none, place = none;
    void add(std::size_t count, std::size_t number, std::size_t at) {
      faults += count;
      if (number < lowest) lowest = number, place = at;
    }
  };
  [[gnu::cold]] void find();

  ParticlesAtWalls const& particles_;
  int dimensions_;
  detail::WallsLook look_;
  Found found_;
};

/// So many wall particles must have a fault, so that single grains that have sunk into a wall do not count.
inline constexpr int many_thin_places = 3;

/// The message for the first wall that is too thin for particles of a spacing (m); "" if no wall is, or if there are
/// fewer than many_thin_places in the case. Where not all of these are here, it is returned where the first one is.
template <class Case = WholeCase>
[[gnu::cold]] std::string fault_of_thin_walls(ParticlesAtWalls const& particles, double spacing, int dimensions,
                                              Case const& of_case = {}) {
  ThinWalls const walls(particles, spacing, dimensions);
  double const lowest = -of_case.largest(-double(walls.lowest()));
  bool const many = of_case.sum(long(walls.faults())) >= many_thin_places;
  return many && walls.faults() > 0 && double(walls.lowest()) == lowest ? walls.text() : "";
}

}  // namespace scree

#ifndef SCREE_COMPILED
#include "thin_walls.ipp"
#endif
