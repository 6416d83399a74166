// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../distributed/profiler.hpp"
#include "ranks_text.hpp"
#include "start.hpp"

#include <cstdio>

namespace scree::app {

/// Prints the table of profile_text() on the first rank if the command line contains --profile:
///
///     Profiler const profiler(solver);
///     run_with(solver, ...);
///     app::print_profile(run, profiler, solver);
///
/// All ranks call this function together.
template <class T, class S>
void print_profile(Run<T> const& run, Profiler const& profiler, S const& solver) {
  if (!run.profile) return;
  auto const text = profile_text(profiler.of(solver));
  if (writes_files()) std::fputs(text.c_str(), stdout);
}

}  // namespace scree::app
