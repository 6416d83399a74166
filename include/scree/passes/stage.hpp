// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/rate.hpp"
#include "fuse.hpp"
#include "resolution.hpp"

// The passes of a physics model grouped by the rates they compute, for integrators that update one part of the state
// before they compute the rates of the next.
namespace scree {

/// Passes that compute the rates of the fields in `evolves`, and passes that return these fields to the admissible set
/// after their update.
template <class Evolved, class Passes, class Projections>
struct Stage {
  using evolves = Evolved;
  Passes passes;
  Projections projections;
};
/// A stage: passes that compute the rates of `Evolved`, and projections after the fields have advanced.
template <class Evolved, class Passes, class Projections = std::tuple<>>
Stage<Evolved, Passes, Projections> stage(Passes const& passes, Projections const& projections = {}) {
  return {passes, projections};
}

namespace detail {

template <class Stages>
struct stages_traits;
template <class... Stages>
struct stages_traits<std::tuple<Stages...>> {
  using evolves = Merge<typename Stages::evolves...>;
  using passes = decltype(std::tuple_cat(std::declval<decltype(Stages::passes)>()...,
                                         std::declval<decltype(Stages::projections)>()...));
};
template <class Integrator>
concept Staggered = requires {
  requires Integrator::staggered;
};
template <class Physics>
concept HasStages = requires(Physics const& physics) {
  typename Physics::evolves;
  std::tuple_size<decltype(physics.stages(Resolution{}))>::value;
};

/// The passes of the stages, for integrators that use them.
template <class Integrator, class Physics>
auto passes_of_stages() {
  if constexpr (Staggered<Integrator> && HasStages<Physics>)
    return std::type_identity<
        typename stages_traits<decltype(std::declval<Physics const&>().stages(Resolution{}))>::passes>();
  else
    return std::type_identity<std::tuple<>>();
}
template <class P>
using staged_passes_of = typename decltype(passes_of_stages<typename P::integrator, typename P::physics>())::type;

/// Whether the stages together evolve exactly the fields that the physics model evolves.
template <class Physics>
constexpr bool stages_are_complete() {
  using InStages = typename stages_traits<decltype(std::declval<Physics const&>().stages(Resolution{}))>::evolves;
  using Wanted = typename Physics::evolves;
  return std::is_same_v<Without<InStages, Wanted>, Fields<>> && std::is_same_v<Without<Wanted, InStages>, Fields<>>;
}

}  // namespace detail

/// A physics model that lists the passes of a state at one time itself.
template <class Physics>
concept GivesPasses = requires(Physics const& physics) {
  typename Physics::evolves;
  std::tuple_size<decltype(physics.passes(Resolution{}))>::value;
};

/// The passes that compute all rates of a state at one time: `passes` of the physics model, or those of its stages in
/// as few sweeps as possible.
template <class Physics>
auto rate_passes(Physics const& physics, Resolution const& resolution) {
  if constexpr (GivesPasses<Physics>)
    return physics.passes(resolution);
  else
    return std::apply([](auto const&... stages) { return fused(std::tuple_cat(stages.passes...)); },
                      physics.stages(resolution));
}

namespace detail {
template <class Physics>
concept GivesProjections = requires(Physics const& physics) {
  std::tuple_size<decltype(physics.projections(Resolution{}))>::value;
};
/// The passes that return an updated state to the admissible set.
template <class Physics>
auto projections_of(Physics const& physics, Resolution const& resolution) {
  if constexpr (GivesProjections<Physics>)
    return physics.projections(resolution);
  else if constexpr (HasStages<Physics>)
    return std::apply([](auto const&... stages) { return std::tuple_cat(stages.projections...); },
                      physics.stages(resolution));
  else
    return std::tuple<>();
}
}  // namespace detail

}  // namespace scree
