// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../checks/packing.hpp"

#include <map>
#include <string>

namespace scree::app {

/// Figures of a finished or stopped run, over all ranks of its case, for its summary.
struct Figures {
  double time = 0;  ///< s
  long steps = 0, neighbour_builds = 0;
  int particles = 0, wall_particles = 0;
  long lost = 0;  ///< particles beyond the walls and the initial material, see Solver::lost()
  std::map<std::string, long> steps_by_limit = {};
  std::string execution_space = {};
  Packing packing = {};  ///< packing of the grains under pressure, see Solver::packing(); empty without a stress
};

/// Returns the figures of a solver in its current state. All ranks call this together.
template <class S>
Figures figures_of(S const& solver) {
  Figures figures{.time = solver.time(),
                  .steps = solver.steps(),
                  .neighbour_builds = solver.neighbour_builds(),
                  .particles = int(solver.ranks().count(solver.material())),
                  .wall_particles = int(solver.ranks().count(solver.wall())),
                  .lost = solver.lost(),
                  .steps_by_limit = solver.limits(),
                  .execution_space = S::policy::space::name()};
  if constexpr (S::has_stress) figures.packing = solver.packing();
  return figures;
}

}  // namespace scree::app
