// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "../core/setting.hpp"
#include "../core/writes_files.hpp"
#include "progress.hpp"

#include <algorithm>
#include <utility>

namespace scree {

SCREE_BODY Progress::Progress(ProgressOptions options)
    : options_(std::move(options)), start_(options_.seconds()), last_(start_) {
  options_.quiet = options_.quiet || !writes_files();
}

SCREE_BODY void Progress::update(double value, long steps) {
  if (!due()) return;
  double const now = options_.seconds();
  last_ = now;
  double const done = std::clamp((value - first_value_) / (options_.end - first_value_), 0.0, 1.0);
  double const left = done > 0 ? (now - start_) * (1 - done) / done : 0;
  show(state(value, steps, now) + ", " + (done > 0 ? clock_text(left) : "?") + " left" +
       (lost_ > 0 ? ", " + std::to_string(lost_) + " lost" : ""));
}

SCREE_BODY void Progress::finish(double value, long steps) {
  if (options_.quiet) return;
  double const now = options_.seconds();
  show(state(value, steps, now) + ", took " + clock_text(now - start_));
  if (open_line_) std::fputc('\n', options_.stream);
  if (lost_ > 0)
    std::fprintf(options_.stream, "%ld particle%s lost: beyond the walls, see docs/checks.md\n", lost_,
                 lost_ == 1 ? " is" : "s are");
  open_line_ = false;
}

SCREE_BODY std::string Progress::state(double value, long steps, double now) const {
  double const rate = now > start_ ? static_cast<double>(steps - first_steps_) / (now - start_) : 0;
  return options_.name + detail::formatted(" %.2f of %s (%.0f %%), %ld steps, %.3g steps/s", value,
                                           detail::short_text(options_.end).c_str(), 100 * value / options_.end, steps,
                                           rate);
}

SCREE_BODY void Progress::say_once(std::string const& note) {
  if (options_.quiet || said_ || note.empty()) return;
  said_ = true;
  std::fprintf(options_.stream, "%snote: %s\n", open_line_ ? "\n" : "", note.c_str());
  std::fflush(options_.stream), open_line_ = false;
}

SCREE_BODY void Progress::show(std::string const& line) {
  std::fprintf(options_.stream, options_.terminal ? "\r%s\x1b[K" : "%s\n", line.c_str());
  open_line_ = options_.terminal;
  std::fflush(options_.stream);
}

}  // namespace scree
