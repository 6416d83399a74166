// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/distributed/gathered.hpp>
#include <scree/distributed/other_ranks.hpp>
#include <scree/distributed/run_on_threads.hpp>
#include <scree/solver/solver.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cstdint>
#include <mutex>
#include <vector>

namespace scree::test {

using Space = Kokkos::DefaultExecutionSpace;

/// A formulation with the sums of OnRanks<F>, whose case has no ranks.
template <class F>
struct Whole : F {
  template <class P>
  using search = ReproducibleList<P>;
};

/// The end of a run, and what happened in it on all ranks.
struct Outcome {
  std::uint64_t hash = 0;
  double time = 0;
  long builds = 0, divisions = 0;
  std::int64_t migrated = 0, ghosts = 0, bytes = 0;
  std::vector<int> sizes;  // of the material on each rank, at the end
};

/// Makes a solver on each rank by make(space, settings), and makes `steps` steps.
template <class F, class Make>
Outcome outcome_on(int ranks, int steps, Make const& make, DividedCase<Space> const& divided = {}) {
  Outcome outcome;
  run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) {
    SolverSettings<OnRanks<F>> settings;
    settings.ranks = divided;
    settings.ranks.team = team;
    auto solver = make(space, settings);
    for (int k = 0; k < steps; ++k) solver.step(1);
    auto const hash = state_hash(solver);
    auto const counts = solver.ranks().counts();
    auto const migrated = team.sum(counts.migrated), ghosts = team.sum(counts.ghosts),
               bytes = team.sum(team.traffic().bytes);
    auto const sizes = team.gather(solver.material().size());
    if (team.rank() == 0)
      outcome = {hash, solver.time(), solver.neighbour_builds(), counts.divisions, migrated, ghosts, bytes, sizes};
  });
  return outcome;
}

/// The hash of a case after `last` steps on some ranks that begin with a snapshot.
template <class F, class Make>
std::uint64_t end_from(Snapshot const& snapshot, int ranks, int last, Make const& make) {
  std::uint64_t hash = 0;
  run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) {
    SolverSettings<OnRanks<F>> settings;
    settings.ranks.team = team;
    auto solver = make(space, settings);
    solver.restore(snapshot);
    solver.check_start();  // changes nothing
    while (solver.steps() < last) solver.step(1);
    auto const found = state_hash(solver);
    if (team.rank() == 0) hash = found;
  });
  return hash;
}
/// Snapshots of a run on some ranks after each of these steps.
template <class F, class Make>
std::vector<Snapshot> snapshots_on(int ranks, std::vector<int> const& after, Make const& make) {
  std::vector<Snapshot> all;
  run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) {
    SolverSettings<OnRanks<F>> settings;
    settings.ranks.team = team;
    auto solver = make(space, settings);
    for (int const steps : after) {
      while (solver.steps() < steps) solver.step(1);
      auto const snapshot = solver.snapshot();
      if (team.rank() == 0) all.push_back(snapshot);
    }
  });
  return all;
}

template <class F, class Make>
void check_restarts(Make const& make, std::vector<int> const& after, int last) {
  auto const on_one = snapshots_on<F>(1, after, make);
  auto const end = outcome_on<F>(1, last, make);
  CHECK(end.builds > 5);
  for (int ranks : {2, 3, 4}) {
    INFO("snapshot of " << ranks << " ranks");
    auto const on_several = snapshots_on<F>(ranks, after, make);
    CHECK(on_several == on_one);
  }
  for (std::size_t k = 0; k < after.size(); ++k)
    for (int ranks : {1, 2, 3, 4}) {
      INFO("snapshot after " << after[k] << " steps on " << ranks << " ranks");
      CHECK(end_from<F>(on_one[k], ranks, last, make) == end.hash);
    }
}

}  // namespace scree::test
