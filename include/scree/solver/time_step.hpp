// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace scree {

/// One reason why a step must not be longer.
struct TimeStepLimit {
  std::string_view name;
  double step = std::numeric_limits<double>::infinity();  // s
};

/// Chooses the step and remembers which limit chose it.
class TimeStepControl {
 public:
  /// The smallest of the limits, shortened so that `remaining` (s) is met without a sliver of a last step. Throws if a
  /// limit is not a positive number.
  double choose(std::vector<TimeStepLimit> const& limits, double remaining) {
    TimeStepLimit binding{"output", remaining};
    for (TimeStepLimit const& limit : limits) {
      if (!(limit.step > 0))
        throw std::runtime_error("scree: the " + std::string(limit.name) + " limit of the time step is " +
                                 std::to_string(limit.step) + " s; the fields it depends on are not finite");
      if (limit.step < binding.step) binding = limit;
    }
    ++counts_[std::string(binding.name)];
    // Equal steps up to the next output instead of many long ones and a very short one.
    return remaining / std::ceil(remaining / binding.step * (1 - 1e-12));
  }
  /// How many steps each limit decided.
  std::map<std::string, long> const& counts() const { return counts_; }
  void restore(std::map<std::string, long> counts) { counts_ = std::move(counts); }

 private:
  std::map<std::string, long> counts_;
};

}  // namespace scree
