// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "field.hpp"

// A field that evolves in time names its rate. A field that passes read must be set, computed or evolved; a field for
// which zero is a valid default has a member `may_stay_zero`, and an evolving field that must be positive has
// `above_zero`; one that must not stand still in single precision has `compensated` (fields/remainder.hpp). These
// fields are used by more than one model; a model declares its own fields next to it.
namespace scree {

/// Rate of the velocity by forces and gravity.
struct Acceleration : Vector<"acceleration", "m/s^2"> {
  static constexpr bool may_stay_zero = true;
};
/// Velocity of a particle; that of a wall particle comes from the motion.
struct Velocity : Vector<"velocity", "m/s"> {
  using rate = Acceleration;
  static constexpr bool compensated = true;
  static constexpr bool may_stay_zero = true;
};
/// Position of a particle, given by the points at the start.
struct Position : Vector<"position", "m"> {
  using rate = Velocity;
  static constexpr bool compensated = true;
};
/// Position of a wall particle at time zero.
struct RestPosition : Vector<"rest position", "m"> {};
/// Mass of a particle.
struct Mass : Scalar<"mass", "kg"> {
  static constexpr bool above_zero = true;
};
/// Rate of the density.
struct DensityRate : Scalar<"density rate", "kg/(m^3 s)"> {};
/// Density of the material at a particle, for models in which it changes.
struct Density : Scalar<"density", "kg/m^3"> {
  using rate = DensityRate;
  static constexpr bool compensated = true;
  static constexpr bool above_zero = true;
};
/// Volume of a particle; in 2D an area. At the start it follows from the spacing, unless it is set.
struct Volume : Scalar<"volume", "m^dim"> {};
/// Rate of the stress by the constitutive law.
struct StressRate : Symmetric3<"stress rate", "Pa/s"> {};
/// Cauchy stress, tension positive.
struct Stress : Symmetric3<"stress", "Pa"> {
  using rate = StressRate;
  static constexpr bool may_stay_zero = true;
};
/// Rate of the concentration of small grains by segregation and diffusion.
struct ConcentrationRate : Scalar<"concentration rate", "1/s"> {};
/// Volume concentration of small grains, 0 to 1.
struct Concentration : Scalar<"concentration", "1"> {
  using rate = ConcentrationRate;
  static constexpr bool compensated = true;
};
/// Velocity gradient $L_{ab} = \partial u_a/\partial x_b$.
struct VelocityGradient : Tensor<"velocity gradient", "1/s"> {};
/// Shear rate $\dot\gamma = \sqrt{2 e:e}$, from the deviator e of the strain rate.
struct ShearRate : Scalar<"shear rate", "1/s"> {};
/// Number of a particle at set-up; sorting does not change it.
struct Identity : Integer<"identity", "1"> {};
/// Number of the group of a particle within its body, from 0, in the order in which `Groups` (fields/groups.hpp) got
/// them.
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
