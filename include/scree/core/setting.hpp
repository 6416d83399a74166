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

/// Returns a string formatted according to the rules of printf. Calls compile faster than concatenations of strings.
[[gnu::format(printf, 1, 2)]] std::string formatted(char const* format, ...);

std::string short_text(double value);

}  // namespace detail

/// Throws std::invalid_argument if `good` is false, with a message such as "scree: cfl must be above 0 and at most 1,
/// not 100". Callers compute `good` with comparisons that are false for a NaN.
void check_setting(bool good, char const* name, double value, char const* allowed);
namespace detail {

/// Returns a range in words, such as "above 0 and at most 1" or "0 or more".
std::string in_words(ParameterRange const& range);

void check_parameter(ParameterAbout const& about, double value, char const* owner);

}  // namespace detail

/// Throws std::invalid_argument if a parameter of a model is out of its range, with a message such as "scree:
/// per_strain (-) of VolumeConsistency must be 0 or more, not -1". `owner` follows the name of the parameter if the
/// name alone is not clear.
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

/// Checks a component with its check() or, if there is none, by its parameters(). Throws std::invalid_argument if a
/// setting is out of range.
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

#ifndef SCREE_COMPILED
#include "setting.ipp"
#endif
