// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/rate.hpp"
#include "../fields/standard.hpp"
#include "turning.hpp"

// Fields of the particles of rigid bodies and of walls that contact needs.
namespace scree {

/// The rigid body that a surface particle belongs to; negative: a wall, or the inside of a body.
struct ContactOwner : Integer<"contact owner", "1"> {};
/// Outward normal of the surface times its flatness: 1 on a plane, less at edges, 0 where there is no normal.
struct Facing : Vector<"facing", "1"> {};
/// Facing at time zero: outward normal of the surface times its flatness.
struct RestFacing : Vector<"rest facing", "1"> {};

/// Overlap with other bodies, m.
struct ContactOverlap : Scalar<"contact overlap", "m"> {};
/// Above zero where another surface is closer than half a spacing.
struct ContactNearness : Scalar<"contact nearness", "1"> {};
/// Tangential velocity relative to the bodies that it touches.
struct ContactSlip : Vector<"contact slip", "m/s"> {};
/// Tangential displacement that friction has kept elastic: the only state of a contact.
struct ContactStretch : Vector<"contact stretch", "m"> {};
/// ContactStretch, limited so that friction can hold it in the present state.
struct HeldStretch : Vector<"held stretch", "m"> {};
/// Friction over the normal force.
struct Traction : Vector<"traction", "1"> {};
/// Force of contacts, in 2D on a slice one metre deep.
struct ContactForce : Vector<"contact force", "N"> {};
/// Moment of contacts about the particle.
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
/// Fields for contact that walls and rigid bodies carry.
using FacingFields = Fields<Velocity, VelocityGradient, ContactOwner, Facing, RestFacing, Traction>;
/// Fields for contact that rigid bodies carry.
using ContactFields = Merge<FacingFields, Fields<ContactOverlap, ContactNearness, ContactSlip, ContactStretch,
                                                 Previous<ContactStretch>, HeldStretch, ContactForce, ContactMoment>>;
/// The fields of a surface particle of a rigid body that evolve, together with RigidPlaces.
using StretchEvolves = Fields<Evolves<ContactStretch, ContactSlip>>;
}  // namespace detail

}  // namespace scree
