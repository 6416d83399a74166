// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "field.hpp"

// A field that evolves in time names its rate. A field that passes read must be set, computed or evolved; a field for
// which zero is a valid default has a member `may_stay_zero`, and an evolving field that must be positive has
// `above_zero`. These fields are used by more than one model; a model declares its own fields next to it.
namespace scree {

struct Acceleration : Vector<"acceleration", "m/s^2"> {
  static constexpr bool may_stay_zero = true;
};
inline constexpr Acceleration acceleration{};
struct Velocity : Vector<"velocity", "m/s"> {
  using rate = Acceleration;
  static constexpr bool may_stay_zero = true;
};
inline constexpr Velocity velocity{};
struct Position : Vector<"position", "m"> {
  using rate = Velocity;
};
inline constexpr Position position{};
/// Position of a wall particle at time zero.
struct RestPosition : Vector<"rest position", "m"> {};
inline constexpr RestPosition rest_position{};
struct Mass : Scalar<"mass", "kg"> {
  static constexpr bool above_zero = true;
};
inline constexpr Mass mass{};
struct DensityRate : Scalar<"density rate", "kg/(m^3 s)"> {};
inline constexpr DensityRate density_rate{};
struct Density : Scalar<"density", "kg/m^3"> {
  using rate = DensityRate;
  static constexpr bool above_zero = true;
};
inline constexpr Density density{};
struct Volume : Scalar<"volume", "m^dim"> {};
inline constexpr Volume volume{};
struct StressRate : Symmetric3<"stress rate", "Pa/s"> {};
inline constexpr StressRate stress_rate{};
/// Cauchy stress, tension positive.
struct Stress : Symmetric3<"stress", "Pa"> {
  using rate = StressRate;
  static constexpr bool may_stay_zero = true;
};
inline constexpr Stress stress{};
struct ConcentrationRate : Scalar<"concentration rate", "1/s"> {};
inline constexpr ConcentrationRate concentration_rate{};
/// Volume concentration of small grains, 0 to 1.
struct Concentration : Scalar<"concentration", "1"> {
  using rate = ConcentrationRate;
};
inline constexpr Concentration concentration{};
struct ShearRate : Scalar<"shear rate", "1/s"> {};
inline constexpr ShearRate shear_rate{};
/// Number of a particle at set-up; sorting does not change it.
struct Identity : Integer<"identity", "1"> {};
inline constexpr Identity identity{};
/// Number of the group of a particle within its body, from 0, in the order in which `Groups` (setup/groups.hpp) got
/// them.
struct Group : Integer<"group", "1"> {};
inline constexpr Group group{};

}  // namespace scree
