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
  std::string name = "t/s";                         ///< name of the advancing quantity
  double unit = 1;                                  ///< divisor of the time of a solver, s
  bool quiet = false;                               ///< print nothing
  std::FILE* stream = stderr;                       ///< standard output stays free for results
  double plain_interval = 10;                       ///< seconds between two lines if the stream is not a terminal
  bool terminal = ::isatty(::fileno(stderr)) == 1;  ///< whether the stream is a terminal
  std::function<double()> seconds = wall_seconds;   ///< a clock
};

namespace detail {
/// Whether S is a solver that counts its lost particles.
template <class S>
concept CountsLost = requires(S const& solver) {
  solver.whole_case().anywhere(true);
  { solver.lost() } -> std::convertible_to<long>;
};
}  // namespace detail

/// A display of the progress of a run, with its rate and the time left:
///     t/s 12.50 of 120 (10 %), 4321 steps, 512 steps/s, 1:02 left
/// A terminal shows one line, which is updated; any other stream gets a new line every ten seconds. If particles are
/// lost (Solver::lost), the lines include their number:
///     t/s 12.50 of 120 (10 %), 4321 steps, 512 steps/s, 1:02 left, 3 lost
/// If rigid bodies, their springs or the motion make steps ten times shorter than the physics model does, a note is
/// printed once (Solver::note_on_steps). If the stream cannot be written (full disk, closed pipe), the text is lost and
/// the run continues. Updates are cheap enough to be called after every step, as run_with() does. If a case has several
/// ranks, only the first rank prints, but all ranks, including quiet ones, must call after_step(solver) and
/// finish(solver) together, because lost particles are counted on all ranks.
class Progress {
 public:
  /// Starts the clock.
  explicit Progress(ProgressOptions options);
  Progress(Progress const&) = delete;
  Progress& operator=(Progress const&) = delete;
  ~Progress() {
    if (open_line_) std::fputc('\n', options_.stream);  // so that an error message starts on a line of its own
  }

  /// Sets the value and the number of steps at the beginning of a run that continues from a checkpoint, so that the
  /// rate and the remaining time refer only to the steps that follow. run_with() calls this function.
  void begin(double value, long steps) {
    if (begun_) return;
    begun_ = true;
    first_value_ = value;
    first_steps_ = steps;
  }

  /// Prints the progress if a line is due. Call this after each step (or frame) with the current value and number of
  /// steps.
  void update(double value, long steps);

  /// Prints the last line, with the final value, the number of steps and the elapsed time.
  void finish(double value, long steps);

  /// Whether a line is to be printed now.
  bool due(double /*time*/ = 0) const {
    return !options_.quiet && options_.seconds() - last_ >= (options_.terminal ? 0.2 : options_.plain_interval);
  }
  template <class S>
  void begin(S const& solver) {
    begin(solver.time() / options_.unit, solver.steps());
  }
  /// Prints the progress of a solver if a line is due. Returns false, because progress never stops a run.
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
  bool said_ = false;  // whether the note on steps was printed
};

}  // namespace scree

#ifndef SCREE_COMPILED
#include "progress.ipp"
#endif
