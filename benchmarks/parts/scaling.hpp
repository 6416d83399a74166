// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../step/box.hpp"
#include "memory.hpp"
#include "plan.hpp"

#include <scree/distributed/gathered.hpp>
#include <scree/distributed/other_parts.hpp>
#include <scree/distributed/profiler.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

// Steps of a box of grains with segregation in 3D: by a solver without parts, and on parts.
namespace scree::bench {

template <class Real>
using Box3d = SegregatingBox<3, Real>;
/// With lists of more than 2^32 candidates on one GPU.
struct LargeOnParts : OnParts<Box3d<float>> {
  template <class P>
  using search = LargeReproducibleList<P>;
};

inline BoxCase case_of(Plan const& plan, int parts) {
  double const times = plan.per_part ? parts : 1;
  return {.particles = times * plan.particles, .shear = plan.shear, .length = times * plan.length};
}

/// Profiles of all parts over repeated groups of steps, the one with the median time.
template <class S>
std::vector<PartProfile> median_profile(S& solver, Plan const& plan) {
  auto const advance = [&](int steps) {
    long const last = solver.steps() + steps;
    solver.run(
        solver.time() + 1e3, {}, [](S const&) { return true; }, [&] { return solver.steps() >= last; });
    solver.space().fence();
  };
  advance(plan.warm_up);
  std::vector<std::vector<PartProfile>> found;
  for (int k = 0; k < plan.repetitions; ++k) {
    Profiler const profiler(solver);
    advance(plan.steps);
    found.push_back(profiler.of(solver));
  }
  auto const middle = found.begin() + plan.repetitions / 2;
  std::nth_element(found.begin(), middle, found.end(),
                   [](auto const& a, auto const& b) { return a[0].seconds < b[0].seconds; });
  return *middle;
}

/// One row of the table, printed by the first part. Times of exchanges and reductions are means over the parts;
/// the least is that of the part that waits least for others.
inline void print_row(std::string const& what, std::vector<PartProfile> const& parts, std::string const& hash) {
  double particles = 0, ghosts = 0, exchanging = 0, gathering = 0, bytes = 0, exchanges = 0;
  double least = parts[0].traffic.exchanging;
  double const steps = double(parts[0].steps), count = double(parts.size());
  for (PartProfile const& part : parts) {
    particles += double(part.particles), ghosts += double(part.ghosts);
    least = std::min(least, part.traffic.exchanging);
    exchanging += part.traffic.exchanging / count, gathering += part.traffic.gathering / count;
    bytes += double(part.traffic.bytes) / count, exchanges += double(part.traffic.exchanges) / count;
  }
  double const seconds = parts[0].seconds / steps;
  fmt::print(
      "| {} | {} | {:.0f} | {:.1f} | {:.2f} | {:.2f} | {:.1f} | {:.0f} | {:.0f} | {:.0f} | {:.1f} | {:.0f} | {} |\n",
      what, parts.size(), particles, 1e6 * seconds, particles / seconds * 1e-6, 100 * ghosts / particles,
      exchanges / steps, 1e-3 * bytes / steps, 1e6 * exchanging / steps, 1e6 * least / steps, 1e6 * gathering / steps,
      steps / std::max(1.0, double(parts[0].builds)), hash);
  std::fflush(stdout);
}

/// The row of a formulation on the parts of a team.
template <class F>
void add_row(Team<Space> const& team, Space const& space, Plan const& plan, std::string const& name) {
  auto const wanted = case_of(plan, team.parts());
  MemoryPeaks peaks(team, plan.memory);
  auto solver =
      plan.divided ? box<F>(wanted, space, {.team = team}, team.share()) : box<F>(wanted, space, {.team = team});
  peaks.note("solver made");
  if (plan.memory) {
    solver.step(1);
    peaks.note("first step");
  }
  auto const profile = median_profile(solver, plan);
  peaks.note("end");
  if (plan.memory) peaks.print(name, profile, plan.one_process);
  auto const hash = plan.hash ? fmt::format("{:016x}", state_hash(solver)) : std::string();
  if (team.part() == 0) print_row(name, profile, hash);
}
/// The rows of one precision; a solver without parts is timed where there is one part.
template <class Real>
void add_rows(Team<Space> const& team, Space const& space, Plan const& plan, std::string const& precision) {
  if (team.parts() == 1 && !plan.memory) {
    auto solver = box<Box3d<Real>>(case_of(plan, 1), space);
    auto const profile = median_profile(solver, plan);
    print_row(precision + ", no parts", profile, "");
  }
  add_row<OnParts<Box3d<Real>>>(team, space, plan, precision);
}

void add_rows_in_float(Team<Space> const& team, Space const& space, Plan const& plan);
void add_rows_in_double(Team<Space> const& team, Space const& space, Plan const& plan);
void add_row_of_large(Team<Space> const& team, Space const& space, Plan const& plan);

}  // namespace scree::bench
