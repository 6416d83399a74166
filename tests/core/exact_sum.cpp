// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/core/exact_sum.hpp>

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <random>
#include <vector>

namespace scree::test::exact_sum_tests {
namespace {

double sum_of(std::vector<double> const& terms) {
  ExactSum sum;
  for (double const term : terms) sum += term;
  return sum.value();
}
/// Terms of all sizes and both signs.
std::vector<double> wild_terms(std::size_t count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-300, 300);
  std::vector<double> terms(count);
  for (double& term : terms) term = std::ldexp(mantissa(random), exponent(random));
  return terms;
}

}  // namespace

TEST_CASE("an exact sum loses nothing", "") {
  CHECK(sum_of({}) == 0);
  CHECK(sum_of({1e300, 1, -1e300}) == 1);
  CHECK(sum_of({1, 1e-300, -1}) == 1e-300);
  CHECK(sum_of({-3, 1}) == -2);
  CHECK(sum_of({5e-324, 5e-324}) == 1e-323);
  CHECK(sum_of({-5e-324}) == -5e-324);
  CHECK(sum_of({1.7976931348623157e308, 1.7976931348623157e308, -1.7976931348623157e308}) == 1.7976931348623157e308);
  CHECK(sum_of(std::vector<double>(10, 0.1)) == 1);
}

TEST_CASE("one term is its own sum", "") {
  for (double const term : wild_terms(1000)) CHECK(sum_of({term}) == term);
}

TEST_CASE("an exact sum does not depend on the order of its terms", "") {
  auto terms = wild_terms(1000);
  double const expected = sum_of(terms);
  std::mt19937 random(2);
  for (int k = 0; k < 10; ++k) {
    std::shuffle(terms.begin(), terms.end(), random);
    CHECK(sum_of(terms) == expected);
  }
}

TEST_CASE("an exact sum does not depend on how its terms are divided", "") {
  auto const terms = wild_terms(1000);
  for (std::size_t parts = 1; parts < 9; ++parts) {
    std::vector<ExactSum> sums(parts);
    for (std::size_t k = 0; k < terms.size(); ++k) sums[k % parts] += terms[k];
    ExactSum total;
    for (ExactSum const& each : sums) total += each;
    CHECK(total.value() == sum_of(terms));
  }
}

TEST_CASE("the sum of terms that are not finite is NaN", "") {
  CHECK(std::isnan(sum_of({1, std::numeric_limits<double>::infinity()})));
  CHECK(std::isnan(sum_of({std::numeric_limits<double>::quiet_NaN(), 1})));
}

}  // namespace scree::test::exact_sum_tests
