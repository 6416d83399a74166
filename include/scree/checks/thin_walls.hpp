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

// The search for walls that are too thin for the support of the kernel. It runs on the host and does not depend on the
// formulation.
namespace scree {

/// The particles of the material, `owned` of them, followed by those of walls, and flags for wall particles that belong
/// to plates or turn. The particles are those of the whole case, or those that are here and near these.
struct ParticlesAtWalls {
  PlacedParticles all;
  std::size_t owned = 0;
  std::vector<char> is_plate;
  std::vector<char> turns;                                          ///< empty: none
  double support = detail::WallView::usual_support;                 ///< support of the kernel, spacings
  std::size_t looked_at = std::numeric_limits<std::size_t>::max();  ///< later wall particles are not here

  /// Inserts the particles of the material before those of walls. The material must have `numbers` if the walls have
  /// them. To be called once.
  [[gnu::cold]] void put_material(PlacedParticles const& material);
  /// Adds the particles of a wall. `shows_means`: whether the boundary scheme gives walls means of the material, except
  /// on plates (boundaries/plates.hpp); otherwise all walls are treated as plates. `turning` has a nonzero entry for
  /// each particle that turns; empty: none.
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
  /// Adds copies of wall particles that are elsewhere and within `reach` (m) of the box around the particles here. Call
  /// this after add_wall() of all walls. `shows_means` is as in add_wall().
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

/// The search for walls that are too thin (thicknesses for the usual support of the kernel):
///   a wall with material on both sides, if one of its particles shows each side a mean to which the other side
///     contributes more than 5 %; in walls of 4 spacings it contributes less
///   a plate of less than 1.75 spacings with material on both sides, which then interacts through it; at the start, of
///     less than 2.5 if it turns: grains come closer to its rows than half a spacing, for which a plate of two rows is
///     too thin
///   a wall of one row of particles with material in front
/// Edges, bodies of a few spacings with material all around and the feet of plates are not checked; periodic images are
/// left out. The threads of the host share the walls; the message names the particle with a fault that has the lowest
/// number.
class ThinWalls {
 public:
  /// The value of lowest() if no particle has a fault.
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  /// Checks the particles at walls with a spacing (m) in 2 or 3 dimensions.
  [[gnu::cold]] ThinWalls(ParticlesAtWalls const& particles, double spacing, int dimensions);
  /// Returns the number of wall particles with a fault.
  std::size_t faults() const { return found_.faults; }
  /// Returns the lowest number of a wall particle with a fault; `none` if no particle has one.
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

/// The smallest number of wall particles with a fault that leads to a message, so that single grains that have sunk
/// into a wall are ignored.
inline constexpr int many_thin_places = 3;

/// Returns the message about the first wall that is too thin for particles with a spacing (m); "" if there is none, or
/// if fewer than many_thin_places wall particles of the case have a fault. If the particles of the case are divided
/// among ranks, only the rank with the first such wall returns the message.
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
