// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "time_step.hpp"

namespace scree {

SCREE_BODY std::string note_on(std::vector<TimeStepLimit> const& limits, std::size_t of_physics) {
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

SCREE_BODY void TimeStepControl::look(std::vector<TimeStepLimit> const& limits, long step) {
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
    // A run that resumes from a checkpoint evaluates the limits once out of turn, and must then ignore the limits that
    // it would not have evaluated without the restart.
    bool const counts = in_turn || limit.change == TimeStepLimit::never;
    if (counts && limit.step < binding_.step) binding_ = limit;
    change = std::min(change, limit.change);
  }
  bool const constant = !binding_.name.empty() && binding_.change == TimeStepLimit::never;
  if (in_turn)
    next_look_ =
        step + (constant ? static_cast<long>(std::clamp(change / binding_.step / 4, 1.0, double(rarest_look))) : 1);
}

SCREE_BODY double TimeStepControl::choose(double remaining) {
  TimeStepLimit const binding = binding_.step < remaining ? binding_ : TimeStepLimit{"output", remaining};
  ++counts_[std::string(binding.name)];
  deciding_ = binding.name;
  // Steps up to the next output have equal length, which avoids a very short last step.
  double const steps = std::ceil(remaining / binding.step * (1 - 1e-12));
  double const step = std::isfinite(steps) ? remaining / steps : binding.step;
  if (std::isinf(step)) throw std::invalid_argument("scree: nothing limits the step: it needs a finite length or end");
  return step;
}

SCREE_BODY void RunEnds::check_after_step(double time, std::string_view limit) {
  if (steps_++ % 1000 != 0) return;
  if (steps_ > 1 && std::isfinite(end_) && std::abs(time - before_) * 1e12 < end_ - time)
    throw std::invalid_argument("scree: 1000 steps to " + detail::short_text(time) + " s, the last by the " +
                                std::string(limit) + " limit, took " + detail::short_text(time - before_) +
                                " s of a run to " + detail::short_text(end_) + " s, which would not end");
  before_ = time;
}

}  // namespace scree
