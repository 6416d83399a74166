// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/core/setting.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <limits>
#include <string>
#include <type_traits>
#include <vector>

// The range of a parameter of a model, for tests of settings.
namespace scree::test {
namespace {

using Catch::Matchers::ContainsSubstring;
using Values = std::vector<double>;
[[maybe_unused]] double const inf = std::numeric_limits<double>::infinity(),
                              nan = std::numeric_limits<double>::quiet_NaN();
[[maybe_unused]] double const tiny = 1e-300, huge = 1e300;

/// A model in which one number is changed: the `good` values are accepted, the `bad` ones and NaN are refused with
/// "scree: NAME must be ALLOWED, not VALUE".
template <class Model, class Number>
void range(Model const& model, Number number, std::string const& name, std::string const& allowed, Values const& good,
           Values bad) {
  CAPTURE(name);
  REQUIRE_NOTHROW(check_settings_of(model));
  using T = std::remove_cvref_t<decltype(number(std::declval<Model&>()))>;
  auto const with = [&](double value) {
    auto changed = model;
    number(changed) = static_cast<T>(value);
    check_settings_of(changed);
  };
  if constexpr (std::is_floating_point_v<T>) bad.push_back(nan);
  for (double const value : good) CHECK_NOTHROW(with(value));
  for (double const value : bad)
    CHECK_THROWS_WITH(with(value), ContainsSubstring("scree: " + name + " must be " + allowed + ", not " +
                                                     detail::short_text(value)));
}
#define OF(member) \
  [](auto& m) -> auto& { return m.member; }

}  // namespace
}  // namespace scree::test
