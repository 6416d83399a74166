// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "field.hpp"

// A field that evolves in time names its rate. A field that passes read must be set, computed or evolved; a field for
// which zero is a valid default has a member `may_stay_zero`, and an evolving field that must be positive has
// `above_zero`; one that must not stand still in single precision has `compensated` (fields/remainder.hpp). These
// fields are used by more than one model; a model declares its own fields next to it.
namespace scree {

struct Acceleration : Vector<"acceleration", "m/s^2"> {
  static constexpr bool may_stay_zero = true;
};
struct Velocity : Vector<"velocity", "m/s"> {
  using rate = Acceleration;
  static constexpr bool compensated = true;
  static constexpr bool may_stay_zero = true;
};
struct Position : Vector<"position", "m"> {
  using rate = Velocity;
  static constexpr bool compensated = true;
};
/// Position of a wall particle at time zero.
struct RestPosition : Vector<"rest position", "m"> {};
struct Mass : Scalar<"mass", "kg"> {
  static constexpr bool above_zero = true;
};
struct DensityRate : Scalar<"density rate", "kg/(m^3 s)"> {};
struct Density : Scalar<"density", "kg/m^3"> {
  using rate = DensityRate;
  static constexpr bool compensated = true;
  static constexpr bool above_zero = true;
};
struct Volume : Scalar<"volume", "m^dim"> {};
struct StressRate : Symmetric3<"stress rate", "Pa/s"> {};
/// Cauchy stress, tension positive.
struct Stress : Symmetric3<"stress", "Pa"> {
  using rate = StressRate;
  static constexpr bool may_stay_zero = true;
};
struct ConcentrationRate : Scalar<"concentration rate", "1/s"> {};
/// Volume concentration of small grains, 0 to 1.
struct Concentration : Scalar<"concentration", "1"> {
  using rate = ConcentrationRate;
  static constexpr bool compensated = true;
};
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
inline constexpr ShearRate shear_rate{};
inline constexpr Identity identity{};
inline constexpr Group group{};
}  // namespace fields

}  // namespace scree
