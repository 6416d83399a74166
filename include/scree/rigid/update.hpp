// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/record.hpp"
#include "motion.hpp"

#include <type_traits>

// The update of rigid bodies by the functions of an integrator, which operate on lists of evolved fields.
namespace scree::detail {

/// A rigid body with its fields and rates, as an integrator reads them. Prescribed components of the velocity have
/// their prescribed values.
template <int Dim, class I>
struct RigidPoint {
  I const& i;
  RigidConstants<Dim> const& body;
  Vec<Dim, double> acceleration;
  Turn<Dim> torque;
  template <Field F>
  SCREE_FN auto operator[](F field) const {
    if constexpr (std::is_same_v<F, RigidAcceleration>)
      return acceleration;
    else if constexpr (std::is_same_v<F, RigidTorque>)
      return torque;
    else if constexpr (std::is_same_v<F, RigidVelocity>)
      return body.given_or(i[field], body.velocity);
    else
      return i[field];
  }
};
/// The new values of a rigid body, as an integrator writes them.
template <int Dim, class O>
struct RigidResults {
  O& out;
  RigidConstants<Dim> const& body;
  template <Field F>
  SCREE_FN auto& operator[](F field) const {
    return out[field];
  }
};

/// The update of rigid bodies by a function of an integrator that evolves some or all fields of RigidEvolves.
/// Afterwards prescribed components of the velocity have their prescribed values, whatever the function stores.
template <class P, class Function>
struct RigidUpdate {
  static constexpr int dim = P::dim;
  using X = Vec<dim, double>;
  using Changed = writes_of<Function>;
  static constexpr bool kicks = OneOf<RigidVelocity, Changed>, moves = OneOf<RigidCentre, Changed>;
  using reads = Merge<Fields<Identity, AngularVelocity>, RigidForces, RigidEvolved, RigidSeen,
                      Without<reads_of<Function>, RigidRates>>;
  using writes = Merge<Fields<AngularVelocity>, Changed, std::conditional_t<moves, Fields<Position>, Fields<>>,
                       std::conditional_t<kicks, RigidSeen, Fields<>>>;
  Function function;
  X gravity;
  Span<RigidConstants<dim> const> constants;

  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    RigidConstants<dim> const& body = constants(i[identity]);
    X const force = i[rigid_force] + i[rigid_contact_force] + i[rigid_spring_force];
    Turn<dim> const moment = i[rigid_moment] + i[rigid_contact_moment] + i[rigid_spring_moment];
    X const a = body.given_or(X(force / body.mass + gravity), zero<X>());
    RigidResults<dim, O> results{out, body};
    function(RigidPoint<dim, I>{i, body, a, moment}, results);
    if constexpr (kicks) out[rigid_velocity] = body.given_or(out[rigid_velocity], body.velocity);
    if constexpr (moves) out[position] = out[rigid_centre].template cast<typename P::real>();
    out[angular_velocity] = body.turning_of(new_or_old(rigid_attitude, i, out), new_or_old(angular_momentum, i, out));
    if constexpr (kicks) see(body, i, a, moment, out);
  }

 private:
  template <class F, class I, class O>
  SCREE_FN static auto const& new_or_old(F field, I const& i, [[maybe_unused]] O& out) {
    if constexpr (OneOf<F, Changed>)
      return out[field];
    else
      return i[field];
  }
  /// Updates the smoothed accelerations that the wall stress uses. The wall stress depends on the acceleration of a
  /// body, and the acceleration of a light body depends on the wall stress: with the present acceleration both would
  /// oscillate.
  template <class I, class O>
  SCREE_FN static void see(RigidConstants<dim> const& body, I const& i, X const& a, Turn<dim> M, O& out) {
    using namespace fields;
    Turn<dim> const w = i[angular_velocity];
    Inertia<dim> const J = in_space(body.inertia, Attitude<dim>(i[rigid_attitude]));
    if constexpr (dim == 3) M -= cross(w, Turn<3>(J * w));
    Turn<dim> const turning = body.turning_of(i[rigid_attitude], M, zero<Turn<dim>>());
    double const share = 0.125;  // a mean over about the last eight updates
    out[seen_acceleration] = i[seen_acceleration] + share * X(a - i[seen_acceleration]);
    out[seen_turning] = i[seen_turning] + share * Turn<dim>(turning - i[seen_turning]);
  }
};

}  // namespace scree::detail
