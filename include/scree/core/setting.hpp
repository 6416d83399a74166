// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "member.hpp"
#include "parameter.hpp"

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
namespace detail {

/// "above 0 and at most 1", "0 or more".
inline std::string in_words(ParameterRange const& range) {
  if (range.words != nullptr) return range.words;
  double const from = range.from, to = range.to;
  bool const has_from = from >= std::numeric_limits<double>::lowest(),
             has_to = to <= std::numeric_limits<double>::max();
  if (!has_from && !has_to) return "finite";
  if (!has_from) return formatted(range.open_end ? "below %.6g" : "at most %.6g", to);
  if (!has_to) return formatted(range.open ? "above %.6g" : "%.6g or more", from);
  char const* const formats[] = {"%.6g to %.6g", "above %.6g and at most %.6g", "from %.6g to below %.6g",
                                 "above %.6g and below %.6g"};
  char text[96];
  std::snprintf(text, sizeof text, formats[(range.open ? 1 : 0) + (range.open_end ? 2 : 0)], from, to);
  return text;
}

inline void check_parameter(ParameterAbout const& about, double value, char const* owner) {
  if (about.range.has(value)) return;
  bool const has_unit = about.unit[0] != '1' || about.unit[1] != 0;
  auto const name = formatted("%s (%s)%s%s", about.name, has_unit ? about.unit : "-", *owner == 0 ? "" : " of ", owner);
  check_setting(false, name.c_str(), value, in_words(about.range).c_str());
}

}  // namespace detail

/// Throws std::invalid_argument for a parameter of the model that is out of its range: "scree: per_strain (-) of
/// VolumeConsistency must be 0 or more, not -1". `owner` follows the name where the name alone is not clear.
template <class Model>
void check_parameters(Model const& model, char const* owner = "") {
  static constexpr auto list = Model::parameters();
  for (auto const& each : list) {
    if constexpr (detail::has_vectors<Model>())
      for (int k = 0; k < each.components(); ++k) detail::check_parameter(each, each.of(model, k), owner);
    else
      detail::check_parameter(each, each.of(model), owner);
  }
}

/// Checks a component by its check(), or by its parameters() if it has no check().
template <class T>
void check_settings_of(T const& part) {
  constexpr bool is_callable = requires { part.check(); };
  static_assert(is_callable || !detail::HasMemberCheck<T>,
                "`check` of this class cannot be called for a constant value: declare it as void check() const");
  if constexpr (is_callable)
    part.check();
  else if constexpr (detail::HasParameters<T>)
    check_parameters(part);
}

}  // namespace scree
