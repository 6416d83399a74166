// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "figures.hpp"
#include "json.hpp"

#include <limits>

namespace scree::app {

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
/// for the loosest and the densest twentieth of these grains. All three are NaN if no grain under pressure has
/// neighbours on all sides.
inline void add_packing(Json::Object& summary, Packing const& packing) {
  auto const add = [&](char const* name, double value) {
    summary.emplace_back(name, packing.full > 0 ? value : std::numeric_limits<double>::quiet_NaN());
  };
  add("packing", packing.density), add("packing_loosest", packing.loose), add("packing_densest", packing.dense);
}

}  // namespace scree::app
