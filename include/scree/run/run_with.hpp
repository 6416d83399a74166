// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <concepts>

namespace scree {

/// Whether a class is a follower of a run, which acts between steps, such as Progress or Checkpoints. Its functions
/// are:
///   due(time)            whether the follower has to act at this time (s); cheap, called after each step
///   after_step(solver)   acts if necessary; returns true to stop the run
///   begin(solver)        optional: called before the run
template <class Follower, class S>
concept FollowsRun = requires(Follower& follower, S const& solver) {
  { follower.due(solver.time()) } -> std::same_as<bool>;
  { follower.after_step(solver) } -> std::same_as<bool>;
};

/// Runs a solver until a time (s) with its observers and followers:
///
///     Progress progress({.end = 2});
///     Checkpoints checkpoints({.file = "checkpoint.h5"});
///     run_with(solver, 2.0, {every<S>(0.1, [&](S& now) { output.append(now); })}, progress, checkpoints);
///
/// Observers act before followers, so that a checkpoint is written after the output of the same time. If a follower
/// stops the run, it ends early, and solver.time() is less than `until`. Throws as Solver::run() does.
template <class S, FollowsRun<S>... Followers>
void run_with(S& solver, double until, typename S::Observers const& observers, Followers&... followers) {
  auto const begin = [&](auto& follower) {
    if constexpr (requires { follower.begin(solver); }) follower.begin(solver);
  };
  (begin(followers), ...);
  solver.run(
      until, observers,
      [&](S const& now) {
        bool stop = false;
        ((stop = followers.after_step(now) || stop), ...);
        return stop;
      },
      [&] { return (followers.due(solver.time()) || ...); });
}

}  // namespace scree
