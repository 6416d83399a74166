// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../checks/packing.hpp"
#include "json.hpp"

#include <limits>
#include <map>
#include <string>

namespace scree::app {

/// Figures of a finished or stopped run, of all ranks of its case, for its summary. All ranks call figures_of()
/// together.
struct Figures {
  double time = 0;  ///< s
  long steps = 0, neighbour_builds = 0;
  int particles = 0, wall_particles = 0;
  long lost = 0;  ///< particles beyond walls and initial material, see Solver::lost()
  std::map<std::string, long> steps_by_limit = {};
  std::string execution_space = {};
  Packing packing = {};  ///< of the grains under pressure, see Solver::packing(); of none without a stress
};

/// The figures of a solver at the present state.
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

/// Adds to a summary the numbers of particles, wall particles, lost ones and steps of a run that took some wall time
/// (s), that time, and the particles times the steps over it: `particles`, `wall_particles`, `lost`, `steps`,
/// `wall_seconds`, `particle_steps_per_second`.
inline void add_counts(Json::Object& summary, Figures const& figures, double wall_seconds) {
  summary.emplace_back("particles", figures.particles);
  summary.emplace_back("wall_particles", figures.wall_particles);
  summary.emplace_back("lost", figures.lost);
  summary.emplace_back("steps", figures.steps);
  summary.emplace_back("wall_seconds", wall_seconds);
  summary.emplace_back("particle_steps_per_second", double(figures.steps) * figures.particles / wall_seconds);
}

/// Adds to a summary the number density of the grains under pressure over that at rest: `packing`, the median of those
/// with others on all sides; `packing_loosest` and `packing_densest`, the values of the loosest and of the densest
/// twentieth of them. All three are NaN if there are none.
inline void add_packing(Json::Object& summary, Packing const& packing) {
  auto const add = [&](char const* name, double value) {
    summary.emplace_back(name, packing.full > 0 ? value : std::numeric_limits<double>::quiet_NaN());
  };
  add("packing", packing.density), add("packing_loosest", packing.loose), add("packing_densest", packing.dense);
}

}  // namespace scree::app
