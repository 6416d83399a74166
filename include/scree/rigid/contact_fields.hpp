// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/rate.hpp"
#include "../fields/standard.hpp"
#include "turning.hpp"

// Fields for contact, carried by the particles of rigid bodies and walls.
namespace scree {

/// The number of the rigid body that a surface particle belongs to; negative for particles of walls and for particles
/// inside a body.
struct ContactOwner : Integer<"contact owner", "1"> {};
/// Outward normal of the surface times its flatness, which is 1 on a plane, less at edges, and 0 for particles without
/// a normal.
struct Facing : Vector<"facing", "1"> {};
/// The field Facing at time zero: outward normal of the surface times its flatness.
struct RestFacing : Vector<"rest facing", "1"> {};

/// Overlap of a surface particle with other bodies and walls, m.
struct ContactOverlap : Scalar<"contact overlap", "m"> {};
/// Nearness to another surface: above zero if that surface is closer than half a spacing.
struct ContactNearness : Scalar<"contact nearness", "1"> {};
/// Tangential velocity of a surface particle relative to the bodies that the particle touches.
struct ContactSlip : Vector<"contact slip", "m/s"> {};
/// Elastic tangential displacement of the friction spring: the only state of a contact.
struct ContactStretch : Vector<"contact stretch", "m"> {};
/// ContactStretch, limited so that the force of the spring does not exceed the friction limit in the present state.
struct HeldStretch : Vector<"held stretch", "m"> {};
/// Friction force divided by the normal force.
struct Traction : Vector<"traction", "1"> {};
/// Contact force on a particle; in 2D on a slice one metre deep.
struct ContactForce : Vector<"contact force", "N"> {};
/// Moment of the contact forces about the particle.
struct ContactMoment : Labelled<"contact moment", "N m"> {
  template <int Dim, class Real>
  using value = Vec<turns_in<Dim>, Real>;
};

namespace fields {
inline constexpr ContactOwner contact_owner{};
inline constexpr Facing facing{};
inline constexpr RestFacing rest_facing{};
inline constexpr ContactOverlap contact_overlap{};
inline constexpr ContactNearness contact_nearness{};
inline constexpr ContactSlip contact_slip{};
inline constexpr ContactStretch contact_stretch{};
inline constexpr HeldStretch held_stretch{};
inline constexpr Traction traction{};
inline constexpr ContactForce contact_force{};
inline constexpr ContactMoment contact_moment{};
}  // namespace fields

namespace detail {
/// Contact fields of walls and rigid bodies.
using FacingFields = Fields<Velocity, VelocityGradient, ContactOwner, Facing, RestFacing, Traction>;
/// Contact fields of rigid bodies.
using ContactFields = Merge<FacingFields, Fields<ContactOverlap, ContactNearness, ContactSlip, ContactStretch,
                                                 Previous<ContactStretch>, HeldStretch, ContactForce, ContactMoment>>;
/// The evolved fields of a surface particle of a rigid body; they evolve together with RigidPlaces.
using StretchEvolves = Fields<Evolves<ContactStretch, ContactSlip>>;
}  // namespace detail

}  // namespace scree
