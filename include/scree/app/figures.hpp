// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../checks/packing.hpp"
#include "json.hpp"

#include <limits>
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

/// Adds to a summary the numbers of particles, wall particles, lost particles and steps of a run, its wall time (s),
/// and the number of particles times the number of steps per wall time: `particles`, `wall_particles`, `lost`, `steps`,
/// `wall_seconds`, `particle_steps_per_second`.
inline void add_counts(Json::Object& summary, Figures const& figures, double wall_seconds) {
  summary.emplace_back("particles", figures.particles);
  summary.emplace_back("wall_particles", figures.wall_particles);
  summary.emplace_back("lost", figures.lost);
  summary.emplace_back("steps", figures.steps);
  summary.emplace_back("wall_seconds", wall_seconds);
  summary.emplace_back("particle_steps_per_second", double(figures.steps) * figures.particles / wall_seconds);
}

/// Adds to a summary the number density of the grains under pressure, divided by the number density at rest. `packing`
/// is the median over the grains with neighbours on all sides; `packing_loosest` and `packing_densest` are the values
/// for the loosest and the densest twentieth of these grains. All three are NaN if there are no such grains.
inline void add_packing(Json::Object& summary, Packing const& packing) {
  auto const add = [&](char const* name, double value) {
    summary.emplace_back(name, packing.full > 0 ? value : std::numeric_limits<double>::quiet_NaN());
  };
  add("packing", packing.density), add("packing_loosest", packing.loose), add("packing_densest", packing.dense);
}

}  // namespace scree::app
