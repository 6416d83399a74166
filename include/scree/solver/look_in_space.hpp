// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../boundaries/on_plate.hpp"
#include "../checks/start_in_space.hpp"
#include "../checks/thin_walls_in_space.hpp"
#include "../formulation/formulation.hpp"
#include "settings.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

// Checks of the particle positions of a solver in the execution space.
namespace scree::detail {

/// Returns the particles of the evolving bodies, followed by those of the bodies for which for_each(visit) calls
/// visit.operator()<Body>(). Returns std::nullopt if the case has several ranks, or if the free memory is less than
/// `bytes` for each particle.
template <class P, class Sys, class ForEach>
[[gnu::cold]] std::optional<Spots<typename P::space>> spots_of(Sys const& system, double bytes,
                                                               ForEach const& for_each) {
  if (system.whole_case().is_shared()) return std::nullopt;
  int owned = 0, count = 0;
  for_each_body(evolving_bodies<P>{}, [&]<class Body>() { owned += system.template body<Body>().size(); });
  for_each([&]<class Body>() { count += system.template body<Body>().size(); });
  count += owned;
  if (double(count) * bytes > free_memory<typename P::space::memory_space>()) return std::nullopt;
  Spots<typename P::space> spots(system.space(), count);
  spots.owned = owned;
  int first = 0;
  auto const copy = [&]<class Body>() {
    spots.copy(system.template body<Body>(), first);
    first += system.template body<Body>().size();
  };
  for_each_body(evolving_bodies<P>{}, copy);
  for_each(copy);
  return spots;
}

/// Calls use(look) with a StartIn of all particles of a system. Returns false, without calling it, if the particles
/// must be checked on the host: if the case has several ranks, if memory is short, or if one bucket contains too many
/// particles.
template <class P, class Sys, class Use>
[[gnu::cold]] bool look_in_space(Sys const& system, SolverSettings<P> const& settings, Use const& use) {
  using Space = typename P::space;
  auto const spots = spots_of<P>(system, StartIn<Space>::bytes,
                                 [](auto const& visit) { for_each_body(following_bodies<P>{}, visit); });
  if (!spots) return false;
  StartIn<Space> look(*spots, settings.spacing, P::dim, settings.periods);
  if (!look.can_look()) return false;
  use(look);
  return true;
}

template <class P>
struct MarkPlates {
  Columns<P, Fields<OnPlate>> columns;
  Span<char> marks;
  int first;
  SCREE_FN void operator()(int i) const { marks(first + i) = columns.load(fields::on_plate, i) > 0; }
};
/// Returns whether the walls are thick enough at all of their particles. The walls are the bodies for which
/// for_each_wall(visit) calls visit.operator()<Body>(). `means` is true if the boundary scheme gives walls means of the
/// material, except on plates. turning.operator()<Body>() returns which particles of a body turn; if the result is
/// empty, none do. Returns false if the host must check the walls, because some are too thin or the device cannot check
/// them.
template <class P, class Sys, class ForEachWall, class Turning>
[[gnu::cold]] bool walls_are_thick(Sys const& system, double spacing, double support, bool means,
                                   ForEachWall const& for_each_wall, Turning const& turning) {
  using Space = typename P::space;
  auto const spots = spots_of<P>(system, SpotsInCells<Space>::bytes + sizeof(Spot), for_each_wall);
  if (!spots) return false;
  int const walls = spots->all.size() - spots->owned;
  if (walls == 0) return true;
  std::vector<char> turns;
  ArrayIn<char, Space> const is_plate(system.space(), "scree::plates", std::size_t(walls));
  if (!means) copy_into(is_plate, std::vector<char>(std::size_t(walls), 1));
  int first = 0;
  for_each_wall([&]<class Body>() {
    auto const& body = system.template body<Body>();
    using Particles = std::remove_cvref_t<decltype(body)>;
    if constexpr (OneOf<OnPlate, typename Particles::fields>)
      if (means)
        for_each_index(system.space(), "scree::plates", 0, body.size(),
                       MarkPlates<typename Particles::policy>{body.select(Fields<OnPlate>{}), is_plate, first});
    std::vector<char> const of_body = turning.template operator()<Body>();
    if (!of_body.empty()) {
      turns.resize(std::size_t(walls), 0);
      std::copy(of_body.begin(), of_body.end(), turns.begin() + first);
    }
    first += body.size();
  });
  ArrayIn<char, Space> turning_walls;
  if (!turns.empty()) turning_walls = {system.space(), "scree::turning", turns.size()}, copy_into(turning_walls, turns);
  return faults_of_thin_walls(*spots, spacing, P::dim, is_plate, turning_walls, support) == 0;
}

template <class P>
struct MarkLoaded {
  Columns<P, Fields<Stress>> columns;
  Span<char> marks;
  SCREE_FN void operator()(int i) const {
    auto const sigma = columns.load(fields::stress, i);
    marks(i) = sigma[0] + sigma[1] + sigma[2] < 0;
  }
};
/// Returns which particles of the material are under pressure.
template <class Body>
auto which_are_loaded(Body const& material) {
  using P = typename Body::policy;
  ArrayIn<char, typename P::space> const marks(material.space(), "scree::loaded", std::size_t(material.size()));
  for_each_index(material.space(), "scree::loaded", 0, material.size(),
                 MarkLoaded<P>{material.select(Fields<Stress>{}), marks});
  return marks;
}

}  // namespace scree::detail
