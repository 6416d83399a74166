// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "wall_clock.hpp"

#include <unistd.h>

#include <concepts>
#include <cstdio>
#include <functional>
#include <string>

namespace scree {

/// Settings of Progress.
struct ProgressOptions {
  double end = 1;                                   ///< value of the advancing quantity at the end
  std::string name = "t/s";                         ///< what advances
  double unit = 1;                                  ///< divisor of the time of a solver, s
  bool quiet = false;                               ///< print nothing
  std::FILE* stream = stderr;                       ///< standard output stays free for results
  double plain_interval = 10;                       ///< seconds between two lines if the stream is not a terminal
  bool terminal = ::isatty(::fileno(stderr)) == 1;  ///< whether the stream is a terminal
  std::function<double()> seconds = wall_seconds;   ///< a clock
};

namespace detail {
/// A solver, whose particles may get lost.
template <class S>
concept CountsLost = requires(S const& solver) {
  solver.whole_case().anywhere(true);
  { solver.lost() } -> std::convertible_to<long>;
};
}  // namespace detail

/// Prints how far a run is, its rate and the time left:
///     t/s 12.50 of 120 (10 %), 4321 steps, 512 steps/s, 1:02 left
/// On a terminal this is one line that changes, elsewhere a new line every ten seconds. Where particles are lost
/// (Solver::lost), the lines say how many:
///     t/s 12.50 of 120 (10 %), 4321 steps, 512 steps/s, 1:02 left, 3 lost
/// Where rigid bodies, their springs or the motion make steps ten times shorter than the physics model, a note says so
/// once (Solver::note_on_steps). A stream that cannot be written (full disk, closed pipe) loses the text; the run
/// continues. Cheap enough to be called every step; run_with() does that. If a case has several ranks, only the first
/// prints; all of them, quiet ones included, call after_step(solver) and finish(solver) together, because lost
/// particles are counted on all ranks.
class Progress {
 public:
  /// Starts the clock.
  explicit Progress(ProgressOptions options);
  Progress(Progress const&) = delete;
  Progress& operator=(Progress const&) = delete;
  ~Progress() {
    if (open_line_) std::fputc('\n', options_.stream);  // so that an error message starts on a line of its own
  }

  /// For a run that continues a checkpoint: the rate and the remaining time count the steps that follow. run_with()
  /// calls it.
  void begin(double value, long steps) {
    if (begun_) return;
    begun_ = true;
    first_value_ = value;
    first_steps_ = steps;
  }

  /// Call after each step (or frame) with the value reached and the number of steps.
  void update(double value, long steps);

  /// The last line: the value and the number of steps reached, and the time it took.
  void finish(double value, long steps);

  /// Returns false: progress never stops a run.
  bool due(double /*time*/ = 0) const {
    return !options_.quiet && options_.seconds() - last_ >= (options_.terminal ? 0.2 : options_.plain_interval);
  }
  template <class S>
  void begin(S const& solver) {
    begin(solver.time() / options_.unit, solver.steps());
  }
  /// Prints if it is time to, as an observer of a run; false, so that the run goes on.
  template <class S>
  bool after_step(S const& solver) {
    if constexpr (detail::CountsLost<S>)
      if (solver.whole_case().anywhere(due())) lost_ = solver.lost();
    if constexpr (requires { std::string(solver.note_on_steps()); }) say_once(solver.note_on_steps());
    update(solver.time() / options_.unit, solver.steps());
    return false;
  }
  template <class S>
  void finish(S const& solver) {
    if constexpr (detail::CountsLost<S>) lost_ = solver.lost();
    finish(solver.time() / options_.unit, solver.steps());
  }

 private:
  std::string state(double value, long steps, double now) const;
  void say_once(std::string const& note);
  void show(std::string const& line);

  ProgressOptions options_;
  double start_, last_, first_value_ = 0;
  long first_steps_ = 0, lost_ = 0;
  bool begun_ = false;
  bool open_line_ = false;
  bool said_ = false;  // a note on the steps
};

}  // namespace scree

#ifndef SCREE_COMPILED
#include "progress.ipp"
#endif
