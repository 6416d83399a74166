// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../motion/prescribe.hpp"
#include "../pairs/for_each_particle.hpp"
#include "../passes/in_turn.hpp"
#include "../passes/run_passes.hpp"
#include "../passes/time_step.hpp"
#include "../rigid/exact_forces.hpp"
#include "../rigid/extent.hpp"
#include "../rigid/limits.hpp"
#include "../rigid/settings.hpp"
#include "../rigid/springs.hpp"
#include "../rigid/update.hpp"
#include "../system/searches.hpp"
#include "../terms/gravity.hpp"
#include "body_at_start.hpp"
#include "body_contact.hpp"
#include "settings.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

// The motion of the rigid bodies of a solver.
namespace scree::detail {

template <class Physics, class Body>
concept GivesReactions = requires(Physics const& physics) {
  std::tuple_size<decltype(physics.template reaction_passes<Body>(Resolution{}))>::value;
};

/// Throws std::invalid_argument unless the bodies move perpendicular to the periodic directions: a particle that leaves
/// through a periodic boundary would re-enter at another point of the body.
template <int Dim>
[[gnu::cold]] void check_periods(std::vector<Rigid<Dim>> const& bodies, std::vector<Period> const& periods) {
  for (Period const& period : periods)
    for (auto const& body : bodies) {
      bool fits = body.given_velocity[std::size_t(period.axis)] == 0.0;
      for (int a = 0; a < turns_in<Dim>; ++a)
        fits = fits && (body.given_turning[std::size_t(a)] == 0.0 || (Dim == 3 && a == period.axis));
      if (!fits)
        throw std::invalid_argument(formatted(
            "scree: a rigid body must not move along the period of axis %d nor turn out of its plane: set these "
            "components of given_velocity and given_turning to 0",
            period.axis));
    }
}

/// Whether forces are summed exactly: for cases that may have several ranks, and for neighbour searches whose sums do
/// not depend on the order of the particles in memory.
template <class P>
inline constexpr bool sums_exactly =
    DividesCase<typename P::template ghosts<basis_of<P>>> ||
    std::is_same_v<typename cells_of<basis_of<P>, typename P::template search<basis_of<P>>>::type,
                   CellList<basis_of<P>, ByPosition>>;

/// The fields of the list `Evolved` that are updated with the fields `Some` of the material: fields of the material or
/// of rigid bodies.
template <class P, class Some, class Evolved>
struct evolved_with_fields {
  using type = Common<Some, Evolved>;
};
template <class P, class Some>
inline constexpr bool moves_bodies =
    OneOf<std::conditional_t<evolves_position<P>, Position, Velocity>, evolved_fields<Some>>;
template <class P, class Some>
struct evolved_with_fields<P, Some, RigidEvolves> {
  using type = Merge<std::conditional_t<OneOf<Velocity, evolved_fields<Some>>, RigidMomenta, Fields<>>,
                     std::conditional_t<moves_bodies<P, Some>, RigidPlaces, Fields<>>>;
};
template <class P, class Some>
struct evolved_with_fields<P, Some, StretchEvolves> {
  using type = std::conditional_t<moves_bodies<P, Some>, StretchEvolves, Fields<>>;
};
template <class P, class Some, class Evolved>
using evolved_with = typename evolved_with_fields<P, Some, Evolved>::type;

template <class P>
class RigidDynamics {
 public:
  static constexpr int dim = P::dim;
  using Basis = basis_of<P>;
  using Body = rigid_body_of<typename P::bodies>;
  static_assert(GivesReactions<typename P::physics, Body>,
                "rigid bodies need a function reaction_passes<Body>(resolution) of the physics, which computes "
                "`wall_force` of a body after the rates, as Granular has it");

  /// Sets the initial states. Throws std::invalid_argument as check_periods() does, and unless each rigid body has one
  /// group with particles, in the same order.
  template <class Sys, class AtStart>
  RigidDynamics(Sys& system, SolverSettings<P> const& settings, AtStart const& all) : settings_(settings.rigid) {
    BodyAtStart<Vec<dim, typename P::real>> const& start = all.template of<Body>();
    auto const count = int(settings_.bodies.size());
    check_periods(settings_.bodies, settings.periods);
    std::vector<int> groups = start.groups;
    if (groups.empty()) groups.assign(start.points.size(), 0);
    extents_.resize(std::size_t(count));
    for (std::size_t k = 0; k < groups.size(); ++k) {
      if (groups[k] >= count) break;
      auto const number = std::size_t(groups[k]);
      extents_[number].add(start.points[k].template cast<double>(), settings_.bodies[number].properties.centre);
    }
    bool const fits =
        std::all_of(extents_.begin(), extents_.end(), [](auto const& each) { return each.particles > 0; }) &&
        std::all_of(groups.begin(), groups.end(), [&](int group) { return group < count; });
    if (!fits)
      throw std::invalid_argument(formatted(
          "scree: `rigid.bodies` of the settings has %d rigid bodies, and the groups of the particles of the %s are "
          "others: each rigid body needs one group with particles, in the same order",
          count, std::string(Body::name).c_str()));
    sums_ = Sums(system.space(), groups, count);
    start_states(system);
  }

  /// Runs check_extent() for each body, and throws as it does.
  [[gnu::cold]] void check_start(double spacing) const {
    for (std::size_t k = 0; k < extents_.size(); ++k)
      check_extent(settings_.bodies[k], extents_[k], spacing, static_cast<int>(k));
  }
  /// Runs scree::detail::check_inside() for all bodies, and throws as it does.
  template <class Sys, class Box>
  [[gnu::cold]] void check_inside(Sys const& system, Box const& box, double support) const {
    auto const centres = system.template body<RigidStates>().to_host(fields::rigid_centre);
    detail::check_inside<dim>(centres, extents_, box.low, box.high, support);
  }

  /// Prepares contact and springs. This function must be called when all particles have their rest positions, and again
  /// when the rest positions of walls change.
  template <class Sys>
  void prepare(Sys& system, SolverSettings<P> const& settings) {
    system.whole_case().require_all_here();
    contact_.prepare(system, settings);
    springs_.prepare(system.space(), settings_);
  }
  BodyContact<P> const& contact() const { return contact_; }
  /// Updates the forces on rigid bodies for the present rates.
  template <class Sys>
  void update_forces(Sys& system, typename P::physics const& physics, Resolution const& resolution) {
    run_passes(system, physics.template reaction_passes<Body>(resolution));
    contact_.update(system);
    sums_.run(system.template whole<Body>(), system.template body<RigidStates>());
    springs_.update(system.template body<RigidStates>());
  }
  /// Updates the rigid bodies by the forces from the last evaluation of the rates. `function` takes a list of evolving
  /// fields and returns a function of one particle. place() then moves the particles of the bodies.
  template <class Sys, class Function>
  void advance(Sys& system, typename P::physics const& physics, Function const& function) const {
    auto const of_body = function(RigidEvolves{});
    using Update = RigidUpdate<Basis, std::remove_const_t<decltype(of_body)>>;
    using States = std::remove_cvref_t<decltype(system.template body<RigidStates>())>;
    using Unknown = Without<typename Update::Changed, Without<typename States::fields, Fields<Position>>>;
    constexpr bool is_known = std::is_same_v<Unknown, Fields<>>;
    static_assert(is_known,
                  "the function of an integrator updates other fields than those of the list that it gets, so that "
                  "rigid bodies would not move: [dt](auto evolved) { return staggered_update<Basis>(evolved, dt); }");
    if constexpr (is_known && !std::is_same_v<typename Update::Changed, Fields<>>)
      for_each_particle<Basis>("scree::rigid_update", system.template body<RigidStates>(),
                               Update{of_body, gravity_on_bodies(physics), constants_});
    contact_.advance(system, function(StretchEvolves{}));
  }
  /// Moves the particles of rigid bodies with their bodies, and rotates the surface normals of rigid bodies and of
  /// walls. `time` (s) applies to the walls.
  template <class Sys>
  void place(Sys& system, typename P::motion const& motion, double time) const {
    using Given = Common<Fields<Velocity, Acceleration, VelocityGradient>, scree::carried_fields<P, Body>>;
    using Motions = RigidMotions<Basis>;
    Motions const motions{system.template body<RigidStates>().select(typename Motions::Reads{}), constants_};
    for_each_particle<Basis>("scree::move_rigid", system.template body<Body>(),
                             in_turn<Basis>(Place<Motions, Given>{motions, 0}, contact_.turning_with(motions)));
    contact_.turn_walls(system, motion, time);
  }
  /// Returns the time step limits that keep every body from turning or moving too far, and that resolve contact and
  /// springs. Synchronizes with the device.
  template <class Sys>
  [[gnu::cold]] std::array<TimeStepLimit, 3> limits(Sys const& system, typename P::physics const& physics,
                                                    double spacing) const {
    auto const& states = system.template body<RigidStates>();
    using Longest = LongestRigidStep<Basis>;
    double const longest =
        reduce(system.space(), "scree::rigid_limits", states.size(),
               Longest{states.select(typename Longest::Reads{}), constants_, gravity_on_bodies(physics),
                       settings_.angle_per_step, settings_.spacings_per_step * spacing});
    return {{{"rigid bodies", longest, longest}, contact_.limit(system, longest), springs_.limit()}};
  }

 private:
  using Sums = std::conditional_t<sums_exactly<P>, ExactRigidSums<Basis>, RigidSums<Basis>>;
  static Vec<dim, double> gravity_on_bodies([[maybe_unused]] typename P::physics const& physics) {
    if constexpr (requires { gravity_of(physics); })
      return gravity_of(physics).template vector<Vec<dim, double>>();
    else
      return zero<Vec<dim, double>>();
  }
  template <class Sys>
  void start_states(Sys& system) {
    using namespace fields;
    std::vector<RigidConstants<dim>> constants;
    std::vector<Vec<dim, double>> x, u;
    std::vector<Vec<dim, typename P::real>> places;
    std::vector<Turn<dim>> L, w;
    std::vector<int> numbers;
    for (auto const& each : settings_.bodies) {
      RigidConstants<dim> body{each.properties.mass,
                               extents_[constants.size()].radius,
                               each.properties.centre,
                               each.properties.inertia,
                               each.velocity,
                               each.angular_velocity,
                               {},
                               {}};
      for (std::size_t a = 0; a < each.given_velocity.size(); ++a)
        if ((body.gives_velocity[a] = each.given_velocity[a].has_value()))
          body.velocity[int(a)] = *each.given_velocity[a];
      for (std::size_t a = 0; a < each.given_turning.size(); ++a)
        if ((body.gives_turning[a] = each.given_turning[a].has_value())) body.turning[int(a)] = *each.given_turning[a];
      numbers.push_back(int(constants.size()));
      constants.push_back(body);
      x.push_back(body.rest_centre), u.push_back(body.velocity), w.push_back(body.turning);
      places.push_back(body.rest_centre.template cast<typename P::real>());
      L.push_back(body.inertia * body.turning);
    }
    constants_ = array_of<Basis>(system.space(), constants);
    auto& states = system.template body<RigidStates>();
    states.resize(int(numbers.size()));
    states.from_host(identity, numbers);
    states.from_host(position, places);
    states.from_host(rigid_centre, x);
    states.from_host(rigid_velocity, u);
    states.fill(rigid_attitude, upright<dim>());
    states.from_host(angular_momentum, L);
    states.from_host(angular_velocity, w);
  }

  RigidBodies<dim> settings_;
  std::vector<ExtentOfBody<dim>> extents_;
  Array<Basis, RigidConstants<dim>> constants_;
  Sums sums_;
  BodyContact<P> contact_;
  RigidSprings<Basis> springs_;
};

/// The replacement for RigidDynamics in formulations without rigid bodies; it does nothing.
struct NoRigidDynamics {
  template <class... Unused>
  explicit NoRigidDynamics(Unused const&...) {}
  template <class... Unused>
  void prepare(Unused const&...) {}
  template <class... Unused>
  void update_forces(Unused const&...) {}
  template <class... Unused>
  void place(Unused const&...) const {}
};
template <class P>
struct rigid_dynamics {
  using type = NoRigidDynamics;
};
template <class P>
requires(has_rigid_bodies<typename P::bodies>) struct rigid_dynamics<P> {
  using type = RigidDynamics<P>;
};

}  // namespace scree::detail
