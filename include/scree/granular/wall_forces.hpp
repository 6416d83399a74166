// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../passes/resolution.hpp"
#include "../terms/wall_force.hpp"

namespace scree {

namespace detail {
template <class Physics>
concept GivesWallForces = requires(Physics const& physics) {
  physics.wall_force_passes(Resolution{});
};
}  // namespace detail

/// Diagnostics of a granular formulation: Solver::update_diagnostics() computes the field `wall_force` (N) of the walls
/// for the present state.
struct WallForces {
  /// Returns the passes of the physics model that compute `wall_force`.
  template <class Physics>
  auto passes(Resolution const& resolution, Physics const& physics) const {
    constexpr bool has_passes = detail::GivesWallForces<Physics>;
    static_assert(has_passes,
                  "WallForces needs a function wall_force_passes(resolution) of the physics, as Granular "
                  "has it");
    if constexpr (has_passes)
      return physics.wall_force_passes(resolution);
    else
      return std::tuple<>();
  }
};

}  // namespace scree
