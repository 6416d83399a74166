// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/tuple.hpp"
#include "../fields/rate.hpp"
#include "fuse.hpp"
#include "resolution.hpp"

// The passes of a physics model grouped by the rates that they compute, for integrators that update one part of the
// state before they compute the rates of the next part.
namespace scree {

/// Passes that compute the rates of the fields in `evolves`, and projections, which are passes that return these fields
/// to the admissible set after their update.
template <class Evolved, class Passes, class Projections>
struct Stage {
  using evolves = Evolved;
  Passes passes;
  Projections projections;
};
/// Returns a stage with passes that compute the rates of `Evolved`, and with projections that run after the update of
/// these fields.
template <class Evolved, detail::AnyTuple Passes, detail::AnyTuple Projections = detail::Tuple<>>
Stage<Evolved, detail::tuple_of<Passes>, detail::tuple_of<Projections>> stage(Passes const& passes,
                                                                              Projections const& projections = {}) {
  return {detail::as_tuple(passes), detail::as_tuple(projections)};
}

namespace detail {

template <class Stages>
struct stages_traits;
template <class... Stages>
struct stages_traits<Tuple<Stages...>> {
  using evolves = Merge<typename Stages::evolves...>;
  using passes = row_type<decltype(Stages::passes)..., decltype(Stages::projections)...>;
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

/// The type of the stages that a physics model returns, as a Tuple.
template <class Physics>
using stages_of = tuple_of<decltype(std::declval<Physics const&>().stages(Resolution{}))>;

/// Returns the type of the passes of all stages if the integrator uses stages, otherwise the type of an empty Tuple.
template <class Integrator, class Physics>
auto passes_of_stages() {
  if constexpr (Staggered<Integrator> && HasStages<Physics>)
    return std::type_identity<typename stages_traits<stages_of<Physics>>::passes>();
  else
    return std::type_identity<Tuple<>>();
}
template <class P>
using staged_passes_of = typename decltype(passes_of_stages<typename P::integrator, typename P::physics>())::type;

/// Whether the stages together evolve exactly the fields that the physics model evolves.
template <class Physics>
constexpr bool stages_are_complete() {
  using InStages = typename stages_traits<stages_of<Physics>>::evolves;
  using Wanted = typename Physics::evolves;
  return std::is_same_v<Without<InStages, Wanted>, Fields<>> && std::is_same_v<Without<Wanted, InStages>, Fields<>>;
}

}  // namespace detail

/// Whether a physics model has a function passes(resolution), which returns all passes for the rates of one state,
/// instead of stages.
template <class Physics>
concept GivesPasses = requires(Physics const& physics) {
  typename Physics::evolves;
  std::tuple_size<decltype(physics.passes(Resolution{}))>::value;
};

namespace detail {
/// Returns the passes of rate_passes() as a Tuple.
template <class Physics>
auto rates_of(Physics const& physics, Resolution const& resolution) {
  if constexpr (GivesPasses<Physics>)
    return as_tuple(physics.passes(resolution));
  else
    return with_values([](auto const&... stages) { return in_fewer_sweeps(in_a_row(stages.passes...)); },
                       physics.stages(resolution));
}
}  // namespace detail

/// Returns the passes that compute all rates of a state at one time: the `passes` of the physics model, or the passes
/// of its stages fused into fewer sweeps.
template <class Physics>
auto rate_passes(Physics const& physics, Resolution const& resolution) {
  return detail::as_std_tuple(detail::rates_of(physics, resolution));
}

namespace detail {
template <class Physics>
concept GivesProjections = requires(Physics const& physics) {
  std::tuple_size<decltype(physics.projections(Resolution{}))>::value;
};
/// Returns the passes that return an updated state to the admissible set.
template <class Physics>
auto projections_of(Physics const& physics, Resolution const& resolution) {
  if constexpr (GivesProjections<Physics>)
    return as_tuple(physics.projections(resolution));
  else if constexpr (HasStages<Physics>)
    return with_values([](auto const&... stages) { return in_a_row(stages.projections...); },
                       physics.stages(resolution));
  else
    return Tuple<>();
}
}  // namespace detail

}  // namespace scree
