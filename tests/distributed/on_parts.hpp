// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/distributed/gathered.hpp>
#include <scree/distributed/other_parts.hpp>
#include <scree/distributed/run_on_parts.hpp>
#include <scree/solver/solver.hpp>

#include <cstdint>
#include <mutex>
#include <vector>

namespace scree::test {

using Host = Kokkos::DefaultHostExecutionSpace;

/// A formulation whose case may have several parts.
template <class F>
struct OnParts : F {
  template <class P>
  using search = ReproducibleList<P>;
  template <class P>
  using ghosts = OtherParts<P>;
};
/// The same without parts.
template <class F>
struct Whole : F {
  template <class P>
  using search = ReproducibleList<P>;
};

/// The end of a run, and what happened in it on all parts.
struct Outcome {
  std::uint64_t hash = 0;
  double time = 0;
  long builds = 0, divisions = 0;
  std::int64_t migrated = 0, ghosts = 0, bytes = 0;
  std::vector<int> sizes;  // of the material on each part, at the end
};

/// Makes a solver on each part by make(space, settings), and makes `steps` steps.
template <class F, class Make>
Outcome outcome_on(int parts, int steps, Make const& make, DividedCase<Host> const& divided = {}) {
  Outcome outcome;
  run_on_parts<Host>(parts, [&](Team<Host> const& team, Host const& space) {
    SolverSettings<OnParts<F>> settings;
    settings.parts = divided;
    settings.parts.team = team;
    auto solver = make(space, settings);
    for (int k = 0; k < steps; ++k) solver.step(1);
    auto const hash = state_hash(solver);
    auto const counts = solver.parts().counts();
    auto const migrated = team.sum(counts.migrated), ghosts = team.sum(counts.ghosts), bytes = team.sum(counts.bytes);
    auto const sizes = team.gather(solver.material().size());
    if (team.part() == 0)
      outcome = {hash, solver.time(), solver.neighbour_builds(), counts.divisions, migrated, ghosts, bytes, sizes};
  });
  return outcome;
}

}  // namespace scree::test
