// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <concepts>

namespace scree {

/// A part of a program that acts between steps, for instance Progress or Checkpoints:
///   due(time)            whether it has to act at this time (s); cheap, called after each step
///   after_step(solver)   acts if it has to; returns true to stop the run
///   begin(solver)        optional: called before the run
template <class Part, class S>
concept FollowsRun = requires(Part& part, S const& solver) {
  { part.due(solver.time()) } -> std::same_as<bool>;
  { part.after_step(solver) } -> std::same_as<bool>;
};

/// Runs a solver until a time (s) with its observers and parts that follow the run. Observers act first, so that a
/// checkpoint comes after the output of the same time. Ends early if a part stops the run: then solver.time() is less
/// than `until`. Throws as Solver::run() does.
///
///     Progress progress({.end = 2});
///     Checkpoints checkpoints({.file = "checkpoint.h5"});
///     run_with(solver, 2.0, {every<S>(0.1, [&](S& now) { output.append(now); })}, progress, checkpoints);
template <class S, FollowsRun<S>... Parts>
void run_with(S& solver, double until, typename S::Observers const& observers, Parts&... parts) {
  auto const begin = [&](auto& part) {
    if constexpr (requires { part.begin(solver); }) part.begin(solver);
  };
  (begin(parts), ...);
  solver.run(
      until, observers,
      [&](S const& now) {
        bool stop = false;
        ((stop = parts.after_step(now) || stop), ...);
        return stop;
      },
      [&] { return (parts.due(solver.time()) || ...); });
}

}  // namespace scree
