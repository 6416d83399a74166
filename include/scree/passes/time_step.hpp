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

  static constexpr double never = std::numeric_limits<double>::infinity();
};

/// Says which limit behind the first ones, which are those of the physics model, is the smallest of all and below a
/// tenth of the smallest of these; "" if none is.
[[gnu::cold]] inline std::string note_on(std::vector<TimeStepLimit> const& limits, std::size_t of_physics) {
  auto const smaller = [](TimeStepLimit const& a, TimeStepLimit const& b) { return a.step < b.step; };
  auto const others = limits.begin() + long(of_physics);
  auto const physics = std::min_element(limits.begin(), others, smaller);
  auto const other = std::min_element(others, limits.end(), smaller);
  if (physics == others || other == limits.end() || !(other->step < 0.1 * physics->step) || std::isinf(physics->step))
    return "";
  return detail::formatted(
      "the steps are those of the limit '%s', %.3g s, which is %.3g times shorter than the next "
      "one, '%s', %.3g s",
      std::string(other->name).c_str(), other->step, physics->step / other->step, std::string(physics->name).c_str(),
      physics->step);
}

/// Chooses the step and remembers which limit chose it. To find a limit that depends on the state takes a sweep over
/// all particles and, on a GPU, a wait; so while a constant limit is far smaller, they are looked at now and then:
/// after a quarter of the shortest time in which the state changes, and after 256 steps at the latest.
class TimeStepControl {
 public:
  static constexpr long rarest_look = 256;  ///< steps from a look to the next, at most
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
                                 detail::short_text(limit.step) + " s; " +
                                 (limit.change == TimeStepLimit::never
                                      ? "a setting that it depends on is out of range"
                                      : "a field or a setting that it depends on is out of range"));
      // A run that goes on from a checkpoint looks once out of turn, and must not see more than it would have.
      bool const counts = in_turn || limit.change == TimeStepLimit::never;
      if (counts && limit.step < binding_.step) binding_ = limit;
      change = std::min(change, limit.change);
    }
    bool const constant = !binding_.name.empty() && binding_.change == TimeStepLimit::never;
    if (in_turn)
      next_look_ =
          step + (constant ? static_cast<long>(std::clamp(change / binding_.step / 4, 1.0, double(rarest_look))) : 1);
  }
  /// The smallest of the limits, shortened so that `remaining` (s) is met without a sliver of a last step.
  double choose(double remaining) {
    TimeStepLimit const binding = binding_.step < remaining ? binding_ : TimeStepLimit{"output", remaining};
    ++counts_[std::string(binding.name)];
    deciding_ = binding.name;
    // Equal steps up to the next output instead of many long ones and a very short one.
    double const steps = std::ceil(remaining / binding.step * (1 - 1e-12));
    double const step = std::isfinite(steps) ? remaining / steps : binding.step;
    if (std::isinf(step))
      throw std::invalid_argument("scree: nothing limits the step: it needs a finite length or end");
    return step;
  }
  /// The limit that decided the last step.
  std::string_view deciding() const { return deciding_; }
  /// How many steps each limit decided.
  std::map<std::string, long> const& counts() const { return counts_; }
  /// Makes the limits be looked at before the step of this number, because the state was changed by hand.
  void look_before(long step) { next_look_ = std::min(next_look_, step); }
  /// The step before which the limits are looked at again.
  long next_look() const { return next_look_; }
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

/// Stops a run whose steps are so short that it would not end: at the pace of the last 1000 it had 10^15 to go.
class RunEnds {
 public:
  explicit RunEnds(double end) : end_(end) {}
  /// `limit`: what decided the step.
  void check_after_step(double time, std::string_view limit) {
    if (steps_++ % 1000 != 0) return;
    if (steps_ > 1 && std::isfinite(end_) && std::abs(time - before_) * 1e12 < end_ - time)
      throw std::invalid_argument("scree: 1000 steps to " + detail::short_text(time) + " s, the last by the " +
                                  std::string(limit) + " limit, took " + detail::short_text(time - before_) +
                                  " s of a run to " + detail::short_text(end_) + " s, which would not end");
    before_ = time;
  }

 private:
  double end_, before_ = 0;
  long steps_ = 0;
};

}  // namespace scree
