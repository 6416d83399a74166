// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../passes/resolution.hpp"
#include "../terms/wall_force.hpp"

namespace scree {

/// Diagnostics of a granular formulation: after Solver::update_diagnostics() the walls carry `wall_force` (N) for the
/// present state.
struct WallForces {
  /// The passes of the physics model that compute `wall_force`.
  template <class Physics>
  auto passes(Resolution const& resolution, Physics const& physics) const {
    static_assert(
        requires { physics.wall_force_passes(resolution); },
        "WallForces needs a function wall_force_passes(resolution) of the physics, as Granular has it");
    return physics.wall_force_passes(resolution);
  }
};

}  // namespace scree
