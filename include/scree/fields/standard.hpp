// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "field.hpp"

// Fields that more than one model uses; a field that only one model uses is declared next to that model. A field that
// evolves in time declares its rate. A field that passes read must be set, computed or evolved, unless zero is a valid
// default and the field has a member `may_stay_zero`. An evolving field that must be positive has a member
// `above_zero`. An evolving field whose small steps must not be lost in single precision has a member `compensated`
// (fields/remainder.hpp).
namespace scree {

/// The rate of the velocity due to forces and gravity.
struct Acceleration : Vector<"acceleration", "m/s^2"> {
  static constexpr bool may_stay_zero = true;
};
/// The velocity of a particle. The velocity of a wall particle comes from the motion.
struct Velocity : Vector<"velocity", "m/s"> {
  using rate = Acceleration;
  static constexpr bool compensated = true;
  static constexpr bool may_stay_zero = true;
};
/// The position of a particle; the points given at the start are the initial positions.
struct Position : Vector<"position", "m"> {
  using rate = Velocity;
  static constexpr bool compensated = true;
};
/// The position of a wall particle at time zero.
struct RestPosition : Vector<"rest position", "m"> {};
/// The mass of a particle.
struct Mass : Scalar<"mass", "kg"> {
  static constexpr bool above_zero = true;
};
/// The rate of the density.
struct DensityRate : Scalar<"density rate", "kg/(m^3 s)"> {};
/// The density of the material at a particle, for models in which the density changes.
struct Density : Scalar<"density", "kg/m^3"> {
  using rate = DensityRate;
  static constexpr bool compensated = true;
  static constexpr bool above_zero = true;
};
/// The volume of a particle, which in 2D is an area. Unless it is set, the initial volume follows from the spacing.
struct Volume : Scalar<"volume", "m^dim"> {};
/// The rate of the stress, given by the constitutive law.
struct StressRate : Symmetric3<"stress rate", "Pa/s"> {};
/// The Cauchy stress; tension is positive.
struct Stress : Symmetric3<"stress", "Pa"> {
  using rate = StressRate;
  static constexpr bool may_stay_zero = true;
};
/// The rate of the concentration of small grains due to segregation and diffusion.
struct ConcentrationRate : Scalar<"concentration rate", "1/s"> {};
/// The volume concentration of small grains, from 0 to 1.
struct Concentration : Scalar<"concentration", "1"> {
  using rate = ConcentrationRate;
  static constexpr bool compensated = true;
};
/// The velocity gradient $L_{ab} = \partial u_a/\partial x_b$.
struct VelocityGradient : Tensor<"velocity gradient", "1/s"> {};
/// The shear rate $\dot\gamma = \sqrt{2 e:e}$, computed from the deviator e of the strain rate.
struct ShearRate : Scalar<"shear rate", "1/s"> {};
/// The number of a particle at set-up, which sorting does not change.
struct Identity : Integer<"identity", "1"> {};
/// The number of the group of a particle within its body. Groups are numbered from 0 in the order in which they were
/// added to `Groups` (fields/groups.hpp).
struct Group : Integer<"group", "1"> {};

namespace fields {
inline constexpr Acceleration acceleration{};
inline constexpr Velocity velocity{};
inline constexpr Position position{};
inline constexpr RestPosition rest_position{};
inline constexpr Mass mass{};
inline constexpr DensityRate density_rate{};
inline constexpr Density density{};
inline constexpr Volume volume{};
inline constexpr StressRate stress_rate{};
inline constexpr Stress stress{};
inline constexpr ConcentrationRate concentration_rate{};
inline constexpr Concentration concentration{};
inline constexpr VelocityGradient velocity_gradient{};
inline constexpr ShearRate shear_rate{};
inline constexpr Identity identity{};
inline constexpr Group group{};
}  // namespace fields

}  // namespace scree
