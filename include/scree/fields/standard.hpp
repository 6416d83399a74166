// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "field.hpp"

// A field that evolves in time names its rate. One that passes read must be set, computed or evolve; where zeros are
// meant without, it has a member `may_stay_zero`; where it evolves and zeros mean nothing, `above_zero`.
// Fields that more than one model uses. A model declares its own fields next to it.
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
/// Where a wall particle is at time zero.
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
/// Number of a particle at setup; outlives sorting.
struct Identity : Integer<"identity", "1"> {};
inline constexpr Identity identity{};

}  // namespace scree
