// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/basis.hpp"
#include "../core/member.hpp"
#include "../core/tuple.hpp"
#include "../integrators/midpoint.hpp"
#include "../kernels/wendland_c2.hpp"
#include "../motion/motion.hpp"
#include "../motion/motion_of_bodies.hpp"
#include "../neighbours/verlet_list.hpp"
#include "../openings/held.hpp"
#include "../passes/pass.hpp"
#include "../passes/resolution.hpp"
#include "../passes/stage.hpp"
#include "../passes/validity.hpp"
#include "../rigid/state.hpp"
#include "../terms/wall_force.hpp"
#include "physics_of.hpp"

#include <concepts>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace scree {

/// Diagnostics without passes.
struct NoDiagnostics {
  /// Returns no passes.
  std::tuple<> passes(Resolution const&) const { return {}; }
};

/// The choices of a solver, each with a name and a default. A formulation is a class that derives from this one, names
/// its `physics` and overrides defaults as needed.
template <int Dim, class Real = double>
struct Formulation {
  static_assert(Dim == 2 || Dim == 3, "scree works in two or three dimensions");
  static_assert(std::is_floating_point_v<Real>, "the numbers of a formulation are float or double");
  static constexpr int dim = Dim;
  using real = Real;
  using space = Kokkos::DefaultExecutionSpace;
  using kernel = WendlandC2;
  template <class P>
  using search = VerletList<P>;
  template <class P>
  using ghosts = PeriodicImages<P>;  ///< the provider of particles beyond the boundaries of the domain
  using integrator = Midpoint;
  using bodies = Bodies<Material, Wall>;  ///< usually one body that evolves, and any number that follow the motion
  using motion = AtRest;
  using diagnostics = NoDiagnostics;  ///< passes that run for output only
  using carries = Fields<>;           ///< fields that no pass needs, carried by the bodies for output
};

/// Whether a class has the passes of a physics model. The members of a physics model are:
///   evolves           fields that the integrator advances; each names its rate
///   passes(resolution)  the passes that compute the rates from the state, a tuple
///   limits(resolution)  the limits of the time step, a tuple, see passes/limit.hpp
/// and, optionally,
///   projections(resolution)  passes that return an updated state to the admissible set (return mapping)
///   filters(resolution)      passes that run at the end of every filter_period()-th step
/// For staggered integrators, a physics model has stages(resolution): a tuple of Stage, which groups the passes and
/// projections by the rates that they compute. `passes` and `projections` then follow from the stages, see
/// rate_passes().
template <class Physics>
concept HasPasses = GivesPasses<Physics> || detail::HasStages<Physics>;

namespace detail {
template <class List, class Others>
inline constexpr bool are_among = std::is_same_v<Without<List, Others>, Fields<>>;
}  // namespace detail

/// Whether a type is a time integrator. The members of a time integrator are:
///   fields<Evolved>                   all fields needed to advance a list of fields, including these
///   advance(solver, longest)          static: takes one step of at most `longest` (s); returns its length
///   staggered                         optional: if true, updates the stages of the physics model one after another
///   largest_cfl                       optional: the largest time step over h/c_s for granular mechanics
///   name                              optional: the name of the integrator in messages (integrators/largest_cfl.hpp)
/// A time integrator uses the functions of Stepper.
template <class I, class Evolved>
concept TimeIntegrator = requires {
  typename I::template fields<Evolved>;
}
&&detail::are_among<evolved_fields<Evolved>, typename I::template fields<Evolved>>;

/// Whether a class has passes that run for output only: a function passes(resolution) or passes(resolution, physics),
/// which returns a tuple.
template <class D, class Physics>
concept DiagnosticPasses = requires(D const& diagnostics, Physics const& physics) {
  requires requires { std::tuple_size<decltype(diagnostics.passes(Resolution{}))>::value; } || requires {
    std::tuple_size<decltype(diagnostics.passes(Resolution{}, physics))>::value;
  };
};

namespace detail {
template <class P>
concept NamesPhysics = requires {
  typename P::physics;
};
}  // namespace detail

/// The bodies of a formulation that follow the motion.
template <class P>
using following_bodies = bodies_named<Wall, typename P::bodies>;
/// The motion of a body.
template <class P, BodyTag Body>
using body_motion = decltype(motion_of_body<Body>(std::declval<typename P::motion const&>()));

namespace detail {
template <class P, class List>
inline constexpr bool all_move = false;
template <class P, class... Bs>
inline constexpr bool all_move<P, Bodies<Bs...>> = (PrescribedMotion<body_motion<P, Bs>, P::dim, typename P::real> &&
                                                    ...);
}  // namespace detail

/// Whether a formulation has a physics model, a kernel and motions that meet their concepts.
template <class P>
concept ValidFormulation = detail::NamesPhysics<P> && HasPasses<typename P::physics> &&
    SmoothingKernel<typename P::kernel> && detail::all_move<P, typename P::bodies>;

namespace detail {
template <class Physics>
concept GivesFilters = requires(Physics const& physics) {
  std::tuple_size<decltype(physics.filters(Resolution{}))>::value;
  { physics.filter_period() } -> std::convertible_to<int>;
};
template <class Physics>
auto filters_of(Physics const& physics, Resolution const& resolution) {
  if constexpr (GivesFilters<Physics>)
    return as_tuple(physics.filters(resolution));
  else
    return Tuple<>();
}
/// Returns the passes of diagnostics, which may receive the physics model so that they need no settings of their own.
template <class Diagnostics, class Physics>
auto diagnostic_passes(Diagnostics const& diagnostics, Resolution const& resolution, Physics const& physics) {
  if constexpr (requires { diagnostics.passes(resolution); })
    return diagnostics.passes(resolution);
  else
    return diagnostics.passes(resolution, physics);
}
template <class P>
using diagnostic_passes_of = decltype(diagnostic_passes(std::declval<typename P::diagnostics const&>(), Resolution{},
                                                        std::declval<typename P::physics const&>()));

/// All passes of the physics model.
template <class Physics>
using all_passes_of = row_type<decltype(rates_of(std::declval<Physics const&>(), Resolution{})),
                               decltype(projections_of(std::declval<Physics const&>(), Resolution{})),
                               decltype(filters_of(std::declval<Physics const&>(), Resolution{}))>;
}  // namespace detail

/// The fields of a body that the passes of a formulation write.
template <class P, class Body>
using written_fields = Merge<fields_written_by<Body, detail::all_passes_of<typename P::physics>>,
                             fields_written_by<Body, detail::staged_passes_of<P>>,
                             fields_written_by<Body, detail::diagnostic_passes_of<P>>>;

/// The fields of a body that the passes of a formulation name, with the identity, position and volume.
template <class P, class Body>
using body_fields =
    Merge<Fields<Identity, Position, Volume>, fields_of_passes<Body, detail::all_passes_of<typename P::physics>>,
          fields_of_passes<Body, detail::staged_passes_of<P>>, fields_of_passes<Body, detail::diagnostic_passes_of<P>>>;

namespace detail {
template <class P>
inline constexpr bool evolves_position = OneOf<Position, evolved_fields<typename P::physics::evolves>>;
/// The fields of a body that determine how the motion moves it.
template <class P, class Body>
using fields_to_move = std::conditional_t<
    RigidTag<Body>, Fields<Group>,
    std::conditional_t<FollowingBody<Body> || !evolves_position<P>, fields_of_motion<body_motion<P, Body>>, Fields<>>>;

/// The remainders of fields that an integrator advances, and of positions that a motion moves step by step.
template <class P, class Body>
using kept_remainders =
    Merge<remainders_of_evolved<P, evolves_of<P, Body>>,
          remainders_of<P, std::conditional_t<evolves_position<P> || std::is_same_v<body_motion<P, Body>, AtRest>,
                                              Fields<>, Fields<Position>>>>;

template <class P, class Body>
struct carried_fields {
  using type = Merge<body_fields<P, Body>, Fields<RestPosition>, fields_to_move<P, Body>,
                     std::conditional_t<has_rigid_bodies<typename P::bodies>, FacingFields, Fields<>>,
                     Without<typename P::carries, Fields<Held>>>;
};
template <class P, EvolvingBody Body>
struct carried_fields<P, Body> {
  using type = Merge<body_fields<P, Body>, typename P::integrator::template fields<evolves_of<P, Body>>,
                     kept_remainders<P, Body>, fields_to_move<P, Body>, typename P::carries>;
};
template <class P, RigidTag Body>
struct carried_fields<P, Body> {
  using type = Merge<body_fields<P, Body>, Fields<RestPosition, WallForce>, ContactFields, fields_to_move<P, Body>,
                     typename P::carries, typename P::integrator::template fields<StretchEvolves>>;
};
template <class P, class List>
struct system_of;
template <class Sys, class Body>
struct with_body;
template <class P, class Search, class Ghosts, class... OfBodies, class Body>
struct with_body<System<P, Search, Ghosts, OfBodies...>, Body> {
  using type = System<P, Search, Ghosts, OfBodies..., Body>;
};
template <class P, class Sys>
struct with_states {
  using type = Sys;
};
template <class P, class Sys>
requires(has_rigid_bodies<typename P::bodies>) struct with_states<P, Sys>
    : with_body<
          Sys,
          BodyWith<RigidStates,
                   Merge<RigidFields, Without<typename P::integrator::template fields<RigidEvolves>, RigidRates>>>> {
};
template <class P, class... Bs>
struct system_of<P, Bodies<Bs...>> {
  using type = System<basis_of<P>, typename P::template search<basis_of<P>>, typename P::template ghosts<basis_of<P>>,
                      BodyWith<Bs, typename carried_fields<P, Bs>::type>...>;
};
}  // namespace detail

/// All fields of a body of a formulation.
template <class P, class Body>
using carried_fields = typename detail::carried_fields<P, Body>::type;
/// All fields of the material of a formulation.
template <class P>
using material_fields = carried_fields<P, Material>;
/// All fields of the walls of a formulation.
template <class P>
using wall_fields = carried_fields<P, Wall>;

/// The bodies of a formulation with their neighbour search.
template <class P>
using system_of = typename detail::with_states<P, typename detail::system_of<P, typename P::bodies>::type>::type;

}  // namespace scree
