// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scree {

/// One reason why a step must not be longer.
struct TimeStepLimit {
  std::string_view name;
  double step = never;  ///< s
  /// Time in which the state that it follows from changes, s; `never` if it follows from constants of the material and
  /// the spacing alone.
  double change = step;

  /// The `change` of limits that do not depend on the state.
  static constexpr double never = std::numeric_limits<double>::infinity();
};

/// Returns a note on the limit that is the smallest of all and below a tenth of the smallest one of the physics model,
/// whose limits are the first `of_physics` ones; "" if there is no such limit.
[[gnu::cold]] std::string note_on(std::vector<TimeStepLimit> const& limits, std::size_t of_physics);

/// Chooses the step, and records which limit determined it. Finding a limit that depends on the state takes a sweep
/// over all particles and, on a GPU, a synchronization. While a constant limit is much smaller than the others, the
/// limits are therefore evaluated only after a quarter of the shortest time in which the state changes, and at least
/// every 256 steps.
class TimeStepControl {
 public:
  static constexpr long rarest_look = 256;  ///< steps from one evaluation to the next, at most
  /// Whether the limits must be evaluated before this step, counted from zero.
  bool must_look(long step) const { return step >= next_look_ || resumed_; }
  /// The limits as they are before this step. Throws if one of them is not a positive number.
  void look(std::vector<TimeStepLimit> const& limits, long step);
  /// The smallest of the limits, s, shortened so that steps of equal length end at `remaining` (s). Throws
  /// std::invalid_argument where neither is finite.
  double choose(double remaining);
  /// The limit that decided the last step.
  std::string_view deciding() const { return deciding_; }
  /// The number of steps that each limit has set.
  std::map<std::string, long> const& counts() const { return counts_; }
  /// Forces an evaluation of the limits before the step of this number, because the user changed the state.
  void look_before(long step) { next_look_ = std::min(next_look_, step); }
  /// The step before which the limits are evaluated next.
  long next_look() const { return next_look_; }
  /// Takes over the counts of steps by limit and the next evaluation from a snapshot. The limits are evaluated before
  /// the next step too.
  void restore(std::map<std::string, long> counts, long next_look) {
    counts_ = std::move(counts);
    next_look_ = next_look;
    resumed_ = true;
  }

 private:
  TimeStepLimit binding_;
  std::string_view deciding_;
  long next_look_ = 0;
  bool resumed_ = false;
  std::map<std::string, long> counts_;
};

/// Detects runs that would not end because their steps are too short: at the rate of the last 1000 steps, more than
/// 10^15 further steps would be needed.
class RunEnds {
 public:
  /// Watches a run up to the time `end`, s.
  explicit RunEnds(double end) : end_(end) {}
  /// Counts a step that ended at a time (s). Throws std::invalid_argument, with `limit`, which decided the step, if the
  /// run would not end.
  void check_after_step(double time, std::string_view limit);

 private:
  double end_, before_ = 0;
  long steps_ = 0;
};

}  // namespace scree

#ifndef SCREE_COMPILED
#include "time_step.ipp"
#endif
