// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "say.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <string>

namespace support {

/// "1:02:03" or "2:03".
inline std::string clock_text(double seconds) {
  auto const s = static_cast<long>(std::clamp(seconds, 0.0, 3.6e8) + 0.5);
  if (s < 3600) return fmt::format("{}:{:02}", s / 60, s % 60);
  return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

struct ProgressOptions {
  double end = 1;              ///< value of the advancing quantity at the end
  std::string name = "t";      ///< what advances, "t/T"
  bool quiet = false;          ///< say nothing
  std::FILE* stream = stderr;  ///< where to; stdout stays free for results
  double plain_interval = 10;  ///< seconds between lines where the stream is not a terminal
  bool terminal = ::isatty(::fileno(stderr)) == 1;
  std::function<double()> seconds = [] {  ///< a clock
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  };
};

/// Says how far a run is, how fast it goes and how long it will take:
///     t/T 12.50 of 120 (10 %), 4321 steps, 512 steps/s, 1:02 left
/// on a terminal as one line that changes, elsewhere as a line now and then; nothing where the stream cannot be
/// written. Cheap enough to call every step.
class Progress {
 public:
  explicit Progress(ProgressOptions options)
      : options_(std::move(options)), start_(options_.seconds()), last_(start_) {}
  Progress(Progress const&) = delete;
  Progress& operator=(Progress const&) = delete;
  ~Progress() {
    if (open_line_) std::fputc('\n', options_.stream);  // so that an error message starts on a line of its own
  }

  /// Call after each step (or frame) with the value reached and the steps done so far.
  void update(double value, long steps) {
    double const now = options_.seconds();
    if (options_.quiet || now - last_ < (options_.terminal ? 0.2 : options_.plain_interval)) return;
    last_ = now;
    double const done = std::clamp(value / options_.end, 0.0, 1.0);
    double const left = done > 0 ? (now - start_) * (1 - done) / done : 0;
    show(fmt::format("{}, {} left", state(value, steps, now), done > 0 ? clock_text(left) : "?"));
  }

  /// The last line: what was done and how long it took.
  void finish(double value, long steps) {
    if (options_.quiet) return;
    double const now = options_.seconds();
    show(fmt::format("{}, took {}", state(value, steps, now), clock_text(now - start_)));
    if (open_line_) std::fputc('\n', options_.stream);
    open_line_ = false;
  }

 private:
  std::string state(double value, long steps, double now) const {
    double const rate = now > start_ ? static_cast<double>(steps) / (now - start_) : 0;
    return fmt::format("{} {:.2f} of {} ({:.0f} %), {} steps, {:.3g} steps/s", options_.name, value, options_.end,
                       100 * value / options_.end, steps, rate);
  }

  void show(std::string const& line) {
    if (options_.terminal)
      say(options_.stream, "\r{}\x1b[K", line);
    else
      say(options_.stream, "{}\n", line);
    open_line_ = options_.terminal;
    std::fflush(options_.stream);
  }

  ProgressOptions options_;
  double start_, last_;
  bool open_line_ = false;
};

}  // namespace support
