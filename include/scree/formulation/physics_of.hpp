// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/bodies.hpp"
#include "../fields/list.hpp"

#include <type_traits>
#include <utility>

// The physics model of each body that evolves.
namespace scree {

/// The bodies of a formulation that evolve.
template <class P>
using evolving_bodies = bodies_named<Material, typename P::bodies>;

namespace detail {
template <class Physics, class Body>
concept HasPhysicsOfBody = requires(Physics const& physics) {
  physics.template of_body<Body>();
};
}  // namespace detail

/// Returns the physics model of a body: `physics` itself, or the model that it holds for this body
/// (physics_of_bodies.hpp).
template <BodyTag Body, class Physics>
auto const& physics_of_body(Physics const& physics) {
  if constexpr (detail::HasPhysicsOfBody<Physics, Body>)
    return physics.template of_body<Body>();
  else
    return physics;
}
/// The type of the physics model of a body of a formulation.
template <class P, BodyTag Body>
using physics_of = std::remove_cvref_t<decltype(physics_of_body<Body>(std::declval<typename P::physics const&>()))>;
/// The list of evolving fields of a body of a formulation.
template <class P, BodyTag Body>
using evolves_of = typename physics_of<P, Body>::evolves;

template <class... Parts>
class PhysicsOfBodies;

namespace detail {
/// Whether several bodies of a formulation evolve.
template <class P>
inline constexpr bool several_evolve = evolving_bodies<P>::count > 1;
/// The fields that a stage of the physics model evolves and that evolve in a given body.
template <class P, class Body, class OfStage>
using evolved_in = Common<OfStage, evolves_of<P, Body>>;
}  // namespace detail

}  // namespace scree
