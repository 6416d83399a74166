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

/// An upper limit on the time step.
struct TimeStepLimit {
  std::string_view name;
  double step = never;  ///< s
  /// Time in which the state that determines the limit changes, s; `never` if the limit follows only from constants of
  /// the material and the spacing.
  double change = step;

  /// The value of `change` for limits that do not depend on the state.
  static constexpr double never = std::numeric_limits<double>::infinity();
};

/// Returns a note on the smallest limit if it does not belong to the physics model and is below a tenth of the smallest
/// limit of the physics model; "" otherwise. The first `of_physics` limits are those of the physics model.
[[gnu::cold]] std::string note_on(std::vector<TimeStepLimit> const& limits, std::size_t of_physics);

/// The choice of the time step and a record of the limits that determined it. A limit that depends on the state costs a
/// sweep over all particles and, on a GPU, a synchronization. While a constant limit is much smaller than the others,
/// the limits are therefore evaluated only after a quarter of the shortest time in which the state changes, and at
/// least every 256 steps.
class TimeStepControl {
 public:
  static constexpr long rarest_look = 256;  ///< steps from one evaluation to the next, at most
  /// Whether the limits must be evaluated before the step of this number, counted from zero.
  bool must_look(long step) const { return step >= next_look_ || resumed_; }
  /// Takes the limits that hold before the step of this number. Throws std::runtime_error if a limit is not a positive
  /// number.
  void look(std::vector<TimeStepLimit> const& limits, long step);
  /// Returns the smallest limit (s), shortened so that steps of equal length cover the time `remaining` (s). Throws
  /// std::invalid_argument if neither is finite.
  double choose(double remaining);
  /// Returns the name of the limit that determined the last step.
  std::string_view deciding() const { return deciding_; }
  /// Returns the number of steps that each limit has determined.
  std::map<std::string, long> const& counts() const { return counts_; }
  /// Forces an evaluation of the limits before the step of this number, for instance after the user has changed the
  /// state.
  void look_before(long step) { next_look_ = std::min(next_look_, step); }
  /// Returns the number of the step before which the limits are evaluated next.
  long next_look() const { return next_look_; }
  /// Restores the number of steps per limit and the step of the next evaluation from a snapshot. The limits are also
  /// evaluated before the next step.
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

/// A check for runs that would not end because their steps are too short: at the rate of the last 1000 steps, such a
/// run would need more than 10^15 further steps.
class RunEnds {
 public:
  /// Monitors a run up to the time `end`, s.
  explicit RunEnds(double end) : end_(end) {}
  /// Counts a step that ended at a time (s). Throws std::invalid_argument if the run would not end; the message names
  /// `limit`, which determined the step.
  void check_after_step(double time, std::string_view limit);

 private:
  double end_, before_ = 0;
  long steps_ = 0;
};

}  // namespace scree

#ifndef SCREE_COMPILED
#include "time_step.ipp"
#endif
