// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdarg>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace scree {
namespace detail {

/// A text by the rules of printf. A sum of strings takes a compiler longer.
[[gnu::format(printf, 1, 2)]] inline std::string formatted(char const* format, ...) {
  char text[1024];
  std::va_list values;
  va_start(values, format);
  std::vsnprintf(text, sizeof text, format, values);
  va_end(values);
  return text;
}

inline std::string short_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace detail

/// Throws std::invalid_argument where a setting is not good: "scree: cfl must be above 0 and at most 1, not 100". Asked
/// with comparisons that a NaN fails.
inline void check_setting(bool good, char const* name, double value, char const* allowed) {
  if (!good)
    throw std::invalid_argument("scree: " + std::string(name) + " must be " + allowed + ", not " +
                                detail::short_text(value));
}
/// Checks the settings of a part that can.
template <class T>
void check_settings_of(T const& part) {
  if constexpr (requires { part.check(); }) part.check();
}

}  // namespace scree
