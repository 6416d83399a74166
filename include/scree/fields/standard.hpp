// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "field.hpp"

// A field that evolves in time names its rate.
// Fields that more than one model uses. A model's own fields stand beside the model.
namespace scree {

struct Velocity : Vector<"velocity", "m/s"> {};
inline constexpr Velocity velocity{};
struct Position : Vector<"position", "m"> {
  using rate = Velocity;
};
inline constexpr Position position{};
struct Mass : Scalar<"mass", "kg"> {};
inline constexpr Mass mass{};
struct Density : Scalar<"density", "kg/m^3"> {};
inline constexpr Density density{};
struct Volume : Scalar<"volume", "m^dim"> {};
inline constexpr Volume volume{};
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
