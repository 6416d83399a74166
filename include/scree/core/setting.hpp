// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "member.hpp"

#include <cstdarg>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace scree {
namespace detail {

/// A string formatted by the rules of printf. It compiles faster than a sum of strings.
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

/// Throws std::invalid_argument for a bad setting: "scree: cfl must be above 0 and at most 1, not 100". Callers write
/// `good` with comparisons that are false for a NaN.
inline void check_setting(bool good, char const* name, double value, char const* allowed) {
  if (!good)
    throw std::invalid_argument("scree: " + std::string(name) + " must be " + allowed + ", not " +
                                detail::short_text(value));
}
/// Checks the settings of a component that has a check().
template <class T>
void check_settings_of(T const& part) {
  constexpr bool is_callable = requires { part.check(); };
  static_assert(is_callable || !detail::HasMemberCheck<T>,
                "`check` of this class cannot be called for a constant value: declare it as void check() const");
  if constexpr (is_callable) part.check();
}

}  // namespace scree
