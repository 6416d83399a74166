// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "compiled.hpp"
#include "setting.hpp"

namespace scree {

SCREE_BODY std::string detail::formatted(char const* format, ...) {
  char text[1024];
  std::va_list values;
  va_start(values, format);
  std::vsnprintf(text, sizeof text, format, values);
  va_end(values);
  return text;
}

SCREE_BODY std::string detail::short_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

SCREE_BODY void check_setting(bool good, char const* name, double value, char const* allowed) {
  if (!good)
    throw std::invalid_argument("scree: " + std::string(name) + " must be " + allowed + ", not " +
                                detail::short_text(value));
}

SCREE_BODY std::string detail::in_words(ParameterRange const& range) {
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

SCREE_BODY void detail::check_parameter(ParameterAbout const& about, double value, char const* owner) {
  if (about.range.has(value)) return;
  bool const has_unit = about.unit[0] != '1' || about.unit[1] != 0;
  auto const name = formatted("%s (%s)%s%s", about.name, has_unit ? about.unit : "-", *owner == 0 ? "" : " of ", owner);
  check_setting(false, name.c_str(), value, in_words(about.range).c_str());
}

}  // namespace scree
