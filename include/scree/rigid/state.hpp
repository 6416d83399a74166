// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/bodies.hpp"
#include "../fields/columns.hpp"
#include "../fields/rate.hpp"
#include "../fields/standard.hpp"
#include "contact_fields.hpp"
#include "turning.hpp"

// The state of rigid bodies: fields of the body RigidStates, which has one particle for each rigid body. These fields
// are in double precision in every formulation. Snapshots, trials and output treat them like all other fields.
namespace scree {

namespace detail {
template <Label Name, Label Unit>
struct RigidVector : Labelled<Name, Unit> {
  template <int Dim, class>
  using value = Vec<Dim, double>;
};
template <Label Name, Label Unit>
struct RigidTurn : Labelled<Name, Unit> {
  template <int Dim, class>
  using value = Turn<Dim>;
};
}  // namespace detail

/// Centre of mass, m.
struct RigidCentre : detail::RigidVector<"rigid centre", "m"> {};
/// Velocity of the centre of mass, m/s.
struct RigidVelocity : detail::RigidVector<"rigid velocity", "m/s"> {};
/// Rotation of a rigid body since time zero: an angle (rad) or a unit quaternion.
struct RigidAttitude : Labelled<"rigid attitude", "1"> {
  template <int Dim, class>
  using value = Attitude<Dim>;
};
/// Angular momentum of a rigid body about its centre, in the axes of space; in 2D of a slice one metre deep.
struct AngularMomentum : detail::RigidTurn<"angular momentum", "kg m^2/s"> {};
/// Angular velocity of a rigid body, in the axes of space.
struct AngularVelocity : detail::RigidTurn<"angular velocity", "rad/s"> {};
/// Acceleration of the centre of mass by all forces; its prescribed components are zero. The acceleration is not
/// stored.
struct RigidAcceleration : detail::RigidVector<"rigid acceleration", "m/s^2"> {};
/// Moment of all forces about the centre. The moment is not stored.
struct RigidTorque : detail::RigidTurn<"rigid torque", "N m"> {};
/// Force of the material on a rigid body; in 2D on a slice one metre deep.
struct RigidForce : detail::RigidVector<"rigid force", "N"> {};
/// Moment of the force of the material about the centre.
struct RigidMoment : detail::RigidTurn<"rigid moment", "N m"> {};
/// Force on a rigid body by contacts with walls and other rigid bodies.
struct RigidContactForce : detail::RigidVector<"rigid contact force", "N"> {};
/// Moment about the centre of a rigid body by contacts with walls and other rigid bodies.
struct RigidContactMoment : detail::RigidTurn<"rigid contact moment", "N m"> {};
/// Force of the springs on a rigid body.
struct RigidSpringForce : detail::RigidVector<"rigid spring force", "N"> {};
/// Moment of the springs about the centre of a rigid body.
struct RigidSpringMoment : detail::RigidTurn<"rigid spring moment", "N m"> {};
/// Acceleration of the centre of mass, smoothed over some steps, for the stress that is extrapolated into the body.
struct SeenAcceleration : detail::RigidVector<"seen acceleration", "m/s^2"> {};
/// Angular acceleration, smoothed over some steps, for the stress that is extrapolated into the body.
struct SeenTurning : detail::RigidTurn<"seen angular acceleration", "rad/s^2"> {};

namespace fields {
inline constexpr RigidCentre rigid_centre{};
inline constexpr RigidVelocity rigid_velocity{};
inline constexpr RigidAttitude rigid_attitude{};
inline constexpr AngularMomentum angular_momentum{};
inline constexpr AngularVelocity angular_velocity{};
inline constexpr RigidAcceleration rigid_acceleration{};
inline constexpr RigidTorque rigid_torque{};
inline constexpr RigidForce rigid_force{};
inline constexpr RigidMoment rigid_moment{};
inline constexpr RigidContactForce rigid_contact_force{};
inline constexpr RigidContactMoment rigid_contact_moment{};
inline constexpr RigidSpringForce rigid_spring_force{};
inline constexpr RigidSpringMoment rigid_spring_moment{};
inline constexpr SeenAcceleration seen_acceleration{};
inline constexpr SeenTurning seen_turning{};
}  // namespace fields

namespace detail {

using RigidEvolved = Fields<RigidCentre, RigidVelocity, RigidAttitude, AngularMomentum>;
using RigidPrevious =
    Fields<Previous<RigidCentre>, Previous<RigidVelocity>, Previous<RigidAttitude>, Previous<AngularMomentum>>;
/// Rates of rigid bodies that are computed from their forces and not stored.
using RigidRates = Fields<RigidAcceleration, RigidTorque>;
using RigidSeen = Fields<SeenAcceleration, SeenTurning>;
using RigidForces =
    Fields<RigidForce, RigidMoment, RigidContactForce, RigidContactMoment, RigidSpringForce, RigidSpringMoment>;
using RigidFields =
    Merge<Fields<Identity, Position, Volume, AngularVelocity>, RigidEvolved, RigidPrevious, RigidForces, RigidSeen>;

/// The constants of a rigid body on the device.
template <int Dim>
struct RigidConstants {
  double mass, radius;  // radius: of the particles about the centre
  Vec<Dim, double> rest_centre;
  Inertia<Dim> inertia;
  Vec<Dim, double> velocity;  // prescribed components
  Turn<Dim> turning;
  bool gives_velocity[Dim], gives_turning[turns_in<Dim>];

  /// Returns a velocity or acceleration in which the prescribed components are taken from `given`.
  SCREE_FN Vec<Dim, double> given_or(Vec<Dim, double> free, Vec<Dim, double> const& given) const {
    for (int axis = 0; axis < Dim; ++axis)
      if (gives_velocity[axis]) free[axis] = given[axis];
    return free;
  }
  /// Returns the solution w of J w = L in the free components; the prescribed components of w are taken from `given`.
  SCREE_FN Turn<Dim> turning_of(Attitude<Dim> const& q, Turn<Dim> L, Turn<Dim> const& given) const {
    Inertia<Dim> J = in_space(inertia, q);
    for (int a = 0; a < turns_in<Dim>; ++a) {
      if (!gives_turning[a]) continue;
      for (int b = 0; b < turns_in<Dim>; ++b) J(a, b) = a == b ? 1 : 0;
      L[a] = given[a];
    }
    return solved(J, L);
  }
  SCREE_FN Turn<Dim> turning_of(Attitude<Dim> const& q, Turn<Dim> const& L) const { return turning_of(q, L, turning); }
  /// Returns the attitude after a time (s) at constant angular momentum, by the implicit midpoint rule on rotations.
  SCREE_FN Attitude<Dim> turned_over(Attitude<Dim> const& q, Turn<Dim> const& L, double time) const {
    Turn<Dim> w = turning_of(q, L);
    for (int k = 0; k < 30; ++k) {
      Turn<Dim> const next = turning_of(turned(q, Turn<Dim>(w * (time / 2))), L);
      double const change = squared_norm(Turn<Dim>(next - w));
      w = next;
      if (change <= 1e-32 * squared_norm(w)) break;
    }
    return turned(q, Turn<Dim>(w * time));
  }
};

/// A rotation of a body at constant angular momentum over a time (s). It can be added to an attitude.
template <int Dim>
struct AddedRotation {
  RigidConstants<Dim> const& body;
  Turn<Dim> L;
  double time;
};
template <int Dim>
SCREE_FN Attitude<Dim> operator+(Attitude<Dim> const& q, AddedRotation<Dim> const& by) {
  return by.body.turned_over(q, by.L, by.time);
}
/// The entry of the attitude in a list `evolves`: the attitude rotates with the angular momentum of a record that has
/// the constants `body`.
struct RotatingAttitude : RigidAttitude {
  using rate = AngularMomentum;
  static constexpr bool has_own_change = true;
  template <class I>
  SCREE_FN static auto change(double step, I const& i) {
    return rotation(i.body, i[AngularMomentum{}], step);
  }

 private:
  template <int Dim>
  SCREE_FN static AddedRotation<Dim> rotation(RigidConstants<Dim> const& body, Turn<Dim> const& L, double time) {
    return {body, L, time};
  }
};
template <>
struct evolution<RotatingAttitude> {
  using field = RigidAttitude;
};

/// The fields of a rigid body that evolve with the velocity of the material (RigidMomenta) and with its position
/// (RigidPlaces): lists like `evolves` of a physics model, for the functions of an integrator.
using RigidMomenta = Fields<Evolves<RigidVelocity, RigidAcceleration>, Evolves<AngularMomentum, RigidTorque>>;
using RigidPlaces = Fields<Evolves<RigidCentre, RigidVelocity>, RotatingAttitude>;
using RigidEvolves = Merge<RigidMomenta, RigidPlaces>;

}  // namespace detail
}  // namespace scree
