// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../step/box.hpp"
#include "memory.hpp"
#include "plan.hpp"

#include <scree/distributed/gathered.hpp>
#include <scree/distributed/other_ranks.hpp>
#include <scree/distributed/profiler.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

// Steps of a box of grains with segregation in 3D: by a solver without ranks, and on ranks.
namespace scree::bench {

template <class Real>
using Box3d = SegregatingBox<3, Real>;
/// With lists of more than 2^32 candidates on one GPU.
struct LargeOnRanks : OnRanks<Box3d<float>> {
  template <class P>
  using search = LargeReproducibleList<P>;
};

inline BoxCase case_of(Plan const& plan, int ranks) {
  double const times = plan.per_rank ? ranks : 1;
  return {.particles = times * plan.particles, .shear = plan.shear, .length = times * plan.length};
}

/// Profiles of all ranks over repeated groups of steps, the one with the median time.
template <class S>
std::vector<RankProfile> median_profile(S& solver, Plan const& plan) {
  auto const advance = [&](int steps) {
    long const last = solver.steps() + steps;
    solver.run(
        solver.time() + 1e3, {}, [](S const&) { return true; }, [&] { return solver.steps() >= last; });
    solver.space().fence();
  };
  advance(plan.warm_up);
  std::vector<std::vector<RankProfile>> found;
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

/// One row of the table, printed by the first rank. Times of exchanges and reductions are means over the ranks;
/// the least is that of the rank that waits least for others.
inline void print_row(std::string const& what, std::vector<RankProfile> const& ranks, std::string const& hash) {
  double particles = 0, ghosts = 0, exchanging = 0, gathering = 0, bytes = 0, exchanges = 0;
  double least = ranks[0].traffic.exchanging;
  double const steps = double(ranks[0].steps), count = double(ranks.size());
  for (RankProfile const& rank : ranks) {
    particles += double(rank.particles), ghosts += double(rank.ghosts);
    least = std::min(least, rank.traffic.exchanging);
    exchanging += rank.traffic.exchanging / count, gathering += rank.traffic.gathering / count;
    bytes += double(rank.traffic.bytes) / count, exchanges += double(rank.traffic.exchanges) / count;
  }
  double const seconds = ranks[0].seconds / steps;
  fmt::print(
      "| {} | {} | {:.0f} | {:.1f} | {:.2f} | {:.2f} | {:.1f} | {:.0f} | {:.0f} | {:.0f} | {:.1f} | {:.0f} | {} |\n",
      what, ranks.size(), particles, 1e6 * seconds, particles / seconds * 1e-6, 100 * ghosts / particles,
      exchanges / steps, 1e-3 * bytes / steps, 1e6 * exchanging / steps, 1e6 * least / steps, 1e6 * gathering / steps,
      steps / std::max(1.0, double(ranks[0].builds)), hash);
  std::fflush(stdout);
}

/// The row of a formulation on the ranks of a team.
template <class F>
void add_row(Team<Space> const& team, Space const& space, Plan const& plan, std::string const& name) {
  auto const wanted = case_of(plan, team.ranks());
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
  if (team.rank() == 0) print_row(name, profile, hash);
}
/// The rows of one precision; a solver without ranks is timed where there is one rank.
template <class Real>
void add_rows(Team<Space> const& team, Space const& space, Plan const& plan, std::string const& precision) {
  if (team.ranks() == 1 && !plan.memory) {
    auto solver = box<Box3d<Real>>(case_of(plan, 1), space);
    auto const profile = median_profile(solver, plan);
    print_row(precision + ", no ranks", profile, "");
  }
  add_row<OnRanks<Box3d<Real>>>(team, space, plan, precision);
}

void add_rows_in_float(Team<Space> const& team, Space const& space, Plan const& plan);
void add_rows_in_double(Team<Space> const& team, Space const& space, Plan const& plan);
void add_row_of_large(Team<Space> const& team, Space const& space, Plan const& plan);

}  // namespace scree::bench
