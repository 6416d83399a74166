// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/fields/remainder.hpp>

#include <scree/fields/standard.hpp>

#include <support/policies.hpp>

#include <catch2/catch_test_macros.hpp>

#include <random>

namespace scree::test::remainder_tests {

TEST_CASE("a sum of two numbers and its rounding error are together the exact sum, in any order and with any signs") {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-12, 12);  // the exact sum fits into 53 bits
  for (int k = 0; k < 100'000; ++k) {
    float const a = std::ldexp(mantissa(random), exponent(random)), b = std::ldexp(mantissa(random), exponent(random));
    auto const [sum, error] = scree::detail::two_sum(a, b);
    REQUIRE(sum == a + b);
    REQUIRE(double(sum) + double(error) == double(a) + double(b));
  }
}

TEST_CASE("a million small changes add up, also as vectors, and as products that a compiler may contract") {
  using V = Vec<3, float>;
  V x(1, -2, 1000), rest = V::Zero();
  V const rate(3, -5, 7);
  float const step = 1e-9f;
  for (int k = 0; k < 1'000'000; ++k) {
    auto const sum = scree::detail::compensated_sum(x, rest, V(step * rate));
    x = sum.value, rest = sum.remainder;
  }
  V const plain = V(1, -2, 1000) + step * rate;
  CHECK(plain == V(1, -2, 1000));
  Vec<3, double> const exact = Vec<3, double>(1, -2, 1000) + 1e6 * double(step) * rate.cast<double>();
  Vec<3, double> const found = x.cast<double>() + rest.cast<double>();
  // A unit in the last place of the remainder, which is 2^-24 of the value or less, in each step.
  for (int axis = 0; axis < 3; ++axis)
    CHECK(std::abs(found[axis] - exact[axis]) < 1e6 * std::abs(exact[axis]) * std::ldexp(1.0, -48));
  for (int axis = 0; axis < 3; ++axis) CHECK(std::abs(rest[axis]) <= std::abs(x[axis]) * std::ldexp(1.0f, -24));
}

TEST_CASE("only fields that are declared so have a remainder, and only in single precision") {
  using Single = Policy<2, float, Kokkos::DefaultHostExecutionSpace>;
  using Double = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
  using List = Fields<Position, Stress, Concentration>;
  STATIC_CHECK(std::is_same_v<remainders_of<Single, List>, Fields<Remainder<Position>, Remainder<Concentration>>>);
  STATIC_CHECK(std::is_same_v<remainders_of<Double, List>, Fields<>>);
  STATIC_CHECK(Field<Remainder<Position>>);
}

}  // namespace scree::test::remainder_tests
