// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../solver/settings.hpp"
#include "cases.hpp"
#include "run.hpp"
#ifdef SCREE_RANKS
#include "../distributed/link.hpp"
#include "../distributed/other_ranks.hpp"
#include "../distributed/place.hpp"
#include "../distributed/run_on_threads.hpp"
#include "ranks_text.hpp"
#include "say.hpp"
#endif
#ifdef SCREE_MPI
#include "../distributed/run_on_mpi.hpp"
#endif

namespace scree::app {
inline namespace SCREE_CASES {

/// The formulation that a program solves in place of F: F itself or, if the program is compiled for ranks, OnRanks<F>.
#ifdef SCREE_RANKS
template <class F>
using AsCompiled = OnRanks<F>;
#else
template <class F>
using AsCompiled = F;
#endif

/// The type of the member `ranks` of solver settings.
template <class P>
using Ranks = decltype(SolverSettings<P>::ranks);

/// Runs a case by simulate(run, space, ranks), where `ranks` belongs in the settings of its solver. An undivided case
/// calls `simulate` once. A divided case calls it on all ranks at the same time, each in a process of mpirun or in a
/// thread with its share of the threads of this process. The ranks call Run::begin(), the solver and all output
/// together; only the first rank prints. Unless the run is quiet, it first prints the transport, its speed, and the
/// host and device of each rank.
///
///     template <class P>
///     int simulate_rank(app::Run<Options> const& run, typename P::space const& space, app::Ranks<P> const& ranks) {
///       Solver<P> solver(space, {.spacing = ..., .ranks = ranks}, points);
///       ...
///     }
///     app::run_ranks<app::AsCompiled<Formulation>>(run, space, run.options.ranks, simulate_rank<...>);
///
/// Returns the exit code of the first rank of this process. Rethrows the exception of a rank.
template <class P, class T, class Simulate>
int run_ranks(Run<T> const& run, typename P::space const& space, [[maybe_unused]] int ranks, Simulate const& simulate) {
#ifdef SCREE_RANKS
  using Space = typename P::space;
  auto const run_rank = [&](Team<Space> const& team, Space const& here) {
    Run<T> rank = run;
    rank.quiet = run.quiet || team.rank() != 0;
    rank.meet = [&team] { team.gather(0); };
    if (!run.quiet) {
      Link const link = measured_link(team, here);
      auto const places = team.gather(place_of(here));
      if (team.rank() == 0) say(stdout, "{}", ranks_text(team.name(here), link, places));
    }
    return simulate(rank, here, Ranks<P>{.team = team});
  };
#ifdef SCREE_MPI
  if (MpiProgram::ranks() > 1) return run_rank(team_of_mpi<Space>(), space);
#endif
  if (ranks > 1) {
    int exit_code = 0;
    run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& here) {
      int const code = run_rank(team, here);
      if (team.rank() == 0) exit_code = code;
    });
    return exit_code;
  }
#endif
  Ranks<P> const undivided{};  // named, because g++ 14 warns about a temporary
  return simulate(run, space, undivided);
}

}  // namespace SCREE_CASES
}  // namespace scree::app
