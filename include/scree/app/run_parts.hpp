// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../solver/settings.hpp"
#include "parts.hpp"
#include "start.hpp"
#ifdef SCREE_PARTS
#include "../distributed/link.hpp"
#include "../distributed/other_parts.hpp"
#include "../distributed/place.hpp"
#include "../distributed/run_on_parts.hpp"
#include "parts_text.hpp"
#include "say.hpp"
#endif
#ifdef SCREE_MPI
#include "../distributed/run_on_ranks.hpp"
#endif

namespace scree::app {
inline namespace SCREE_CASES {

/// The formulation that a program solves in place of F: F itself, or OnParts<F> where it is compiled for parts.
#ifdef SCREE_PARTS
template <class F>
using AsCompiled = OnParts<F>;
#else
template <class F>
using AsCompiled = F;
#endif

/// The member `parts` of the settings of its solver.
template <class P>
using Parts = decltype(SolverSettings<P>::parts);

/// Runs a case by simulate(run, space, parts), where `parts` belongs to the settings of its solver: once for a whole
/// case; for each part of a divided one, at the same time, on a rank of mpirun, or in a thread with its share of the
/// threads of this process. The parts call Run::begin(), the solver and all output together; only the first prints.
/// Unless the run is quiet, it first prints the transport, its speed and the place of each part.
/// Returns the exit code of the first part. Throws what one of them threw.
///
///     template <class P>
///     int simulate_part(app::Run<Options> const& run, typename P::space const& space, app::Parts<P> const& parts) {
///       Solver<P> solver(space, {.spacing = ..., .parts = parts}, points);
///       ...
///     }
///     app::run_parts<app::AsCompiled<Formulation>>(run, space, run.options.parts, simulate_part<...>);
template <class P, class T, class Simulate>
int run_parts(Run<T> const& run, typename P::space const& space, [[maybe_unused]] int parts, Simulate const& simulate) {
#ifdef SCREE_PARTS
  using Space = typename P::space;
  auto const run_part = [&](Team<Space> const& team, Space const& here) {
    Run<T> part = run;
    part.quiet = run.quiet || team.part() != 0;
    part.meet = [&team] { team.gather(0); };
    if (!run.quiet) {
      Link const link = measured_link(team, here);
      auto const places = team.gather(place_of(here));
      if (team.part() == 0) say(stdout, "{}", parts_text(team.name(here), link, places));
    }
    return simulate(part, here, Parts<P>{.team = team});
  };
#ifdef SCREE_MPI
  if (MpiProgram::ranks() > 1) return run_part(team_of_ranks<Space>(), space);
#endif
  if (parts > 1) {
    int exit_code = 0;
    run_on_parts<Space>(parts, [&](Team<Space> const& team, Space const& here) {
      int const code = run_part(team, here);
      if (team.part() == 0) exit_code = code;
    });
    return exit_code;
  }
#endif
  Parts<P> const undivided{};  // g++ 14 warns of a temporary
  return simulate(run, space, undivided);
}

}  // namespace SCREE_CASES
}  // namespace scree::app
