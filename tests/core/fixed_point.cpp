// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/core/fixed_point.hpp>

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace scree::test::fixed_point_tests {

TEST_CASE("a sum in fixed point does not depend on the order, and is right to its unit") {
  std::vector<double> terms;
  double exact = 0;
  for (int k = 1; k <= 10'000; ++k) terms.push_back(std::sin(double(k)) * std::pow(10, k % 9 - 8));
  FixedPoint const unit(1, double(terms.size()));
  auto const sum = [&] {
    std::int64_t total = 0;
    for (double const term : terms) total += unit.whole(term);
    return total;
  };
  std::int64_t const first = sum();
  long double precise = 0;
  for (double const term : terms) precise += term;
  exact = double(precise);
  // 10^4 terms, each wrong by half a unit of at most 10^4 2^-60.
  CHECK(std::abs(unit.value(first) - exact) < 1e4 * 0.5 * 1e4 * std::ldexp(1, -60));
  std::sort(terms.begin(), terms.end());
  CHECK(sum() == first);
  std::reverse(terms.begin(), terms.end());
  CHECK(sum() == first);
}

TEST_CASE("the largest sum fits, and a unit is smaller the fewer terms there are") {
  for (double const largest : {1.0, 3.7e-200, 5e200, 0.999999, 4.0})
    for (double const number : {1.0, 2.0, 1e6, 1e9}) {
      FixedPoint const unit(largest, number);
      double const units = double(unit.whole(largest)) * number;
      CHECK(units < 9.2e18);
      CHECK(units > 1e18);
      CHECK(std::abs(unit.value(unit.whole(largest)) / largest - 1) < number * 1e-18);
      CHECK(unit.whole(-largest) == -unit.whole(largest));
    }
  CHECK(FixedPoint(0, 100).whole(0) == 0);
  CHECK(FixedPoint(1, 0).value(FixedPoint(1, 0).whole(0.5)) == 0.5);
}

TEST_CASE("a largest term that is not finite is refused") {
  for (double const bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), -1.0}) {
    CHECK_THROWS_AS(FixedPoint(bad, 1), std::invalid_argument);
    CHECK_THROWS_AS(FixedPoint(1, bad), std::invalid_argument);
  }
}

}  // namespace scree::test::fixed_point_tests
