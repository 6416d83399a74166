// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/core/available_memory.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <limits>

namespace scree::test::room_tests {

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;

TEST_CASE("more particles than an int can count are refused with their number") {
  CHECK(checked_count(0) == 0);
  CHECK(checked_count(2147483647) == 2147483647);
  auto const why =
      " particles are more than the 2147483647 that can be counted; a larger spacing or smaller lengths (check their "
      "unit) make fewer";
  CHECK_THROWS_WITH(checked_count(std::size_t(1) << 31), StartsWith("scree: 2.14748e+09") && ContainsSubstring(why));
  CHECK_THROWS_AS(checked_count((std::size_t(1) << 32) + 5), std::invalid_argument);  // 5 as an int
  CHECK_THROWS_WITH(check_number(1e13), StartsWith("scree: 1e+13") && ContainsSubstring(why));
  CHECK_THROWS_AS(check_number(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

TEST_CASE("particles that do not fit into memory are refused with the memory they need") {
  double const there = available_memory();
  CHECK(there > 1e6);
  CHECK_NOTHROW(check_memory(1000, 8));
  if (!(there < 1e15)) SKIP("the system does not tell its memory");
  CHECK_THROWS_WITH(
      check_memory(1e9, 1e6),
      StartsWith("scree: 1e+09 particles need 1e+06 GB of memory, ") &&
          ContainsSubstring(" GB are there; a larger spacing or smaller lengths (check their unit) make fewer"));
}

TEST_CASE("memory that others need does not count as free") {
  assume_free_memory(5e6);
  CHECK_NOTHROW(check_memory(1e6, 4));
  CHECK_THROWS_WITH(check_memory(1e6, 8),
                    "scree: 1e+06 particles need 0.008 GB of memory, 0.005 GB are there; a larger spacing or smaller "
                    "lengths (check their unit) make fewer");
  assume_free_memory(std::numeric_limits<double>::infinity());
  CHECK_NOTHROW(check_memory(1e6, 8));
}

TEST_CASE("a setting that is not good is named with its value and what is allowed") {
  CHECK_NOTHROW(check_setting(true, "cfl", 0.4, "above 0"));
  CHECK_THROWS_WITH(check_setting(false, "cfl", -2, "above 0 and at most 1"),
                    "scree: cfl must be above 0 and at most 1, not -2");
}

}  // namespace scree::test::room_tests
