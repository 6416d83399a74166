// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <cmath>
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

  static constexpr double never = std::numeric_limits<double>::infinity();
};

/// Chooses the step and remembers which limit chose it. To find a limit that depends on the state takes a sweep over
/// all particles and, on a GPU, a wait; so while a constant limit is far smaller, they are looked at now and then:
/// after a quarter of the shortest time in which the state changes, and after 256 steps at the latest.
class TimeStepControl {
 public:
  /// Whether the limits must be looked at before this step, counted from zero.
  bool must_look(long step) const { return step >= next_look_ || resumed_; }
  /// The limits as they are before this step. Throws if one of them is not a positive number.
  void look(std::vector<TimeStepLimit> const& limits, long step) {
    bool const in_turn = !resumed_ || step >= next_look_;
    resumed_ = false;
    binding_ = {"", TimeStepLimit::never};
    double change = TimeStepLimit::never;
    for (TimeStepLimit const& limit : limits) {
      if (!(limit.step > 0))
        throw std::runtime_error("scree: the " + std::string(limit.name) + " limit of the time step is " +
                                 std::to_string(limit.step) + " s; the fields it depends on are not finite");
      // A run that goes on from a checkpoint looks once out of turn, and must not see more than it would have.
      bool const counts = in_turn || limit.change == TimeStepLimit::never;
      if (counts && limit.step < binding_.step) binding_ = limit;
      change = std::min(change, limit.change);
    }
    bool const constant = !binding_.name.empty() && binding_.change == TimeStepLimit::never;
    if (in_turn)
      next_look_ = step + (constant ? static_cast<long>(std::clamp(change / binding_.step / 4, 1.0, 256.0)) : 1);
  }
  /// The smallest of the limits, shortened so that `remaining` (s) is met without a sliver of a last step.
  double choose(double remaining) {
    TimeStepLimit const binding = binding_.step < remaining ? binding_ : TimeStepLimit{"output", remaining};
    ++counts_[std::string(binding.name)];
    // Equal steps up to the next output instead of many long ones and a very short one.
    return remaining / std::ceil(remaining / binding.step * (1 - 1e-12));
  }
  /// How many steps each limit decided.
  std::map<std::string, long> const& counts() const { return counts_; }
  /// The step before which the limits are looked at again.
  long next_look() const { return next_look_; }
  void restore(std::map<std::string, long> counts, long next_look) {
    counts_ = std::move(counts);
    next_look_ = next_look;
    resumed_ = true;
  }

 private:
  TimeStepLimit binding_;
  long next_look_ = 0;
  bool resumed_ = false;
  std::map<std::string, long> counts_;
};

}  // namespace scree
