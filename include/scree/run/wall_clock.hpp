// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

namespace scree {

/// Returns the time (s) of a clock that never runs backwards.
inline double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Returns a time (s) as text: "1:02:03", or "2:03" for less than an hour.
inline std::string clock_text(double seconds) {
  auto const s = static_cast<long>(std::clamp(seconds, 0.0, 3.6e8) + 0.5);
  char text[40];
  if (s < 3600)
    std::snprintf(text, sizeof text, "%ld:%02ld", s / 60, s % 60);
  else
    std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", s / 3600, s / 60 % 60, s % 60);
  return text;
}

}  // namespace scree
