// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/standard.hpp"

namespace scree {

/// Marker of plates: 1 for wall particles of a plate, 0 for all other wall particles. It is set by
/// `set_group<Wall>(solver, walls, "blade", on_plate, ...)`.
struct OnPlate : Scalar<"on plate", "1"> {
  static constexpr bool may_stay_zero = true;
};

namespace fields {
inline constexpr OnPlate on_plate{};
}  // namespace fields

}  // namespace scree
