// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/core/root.hpp>

#include <support/points.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

namespace scree::test::root_tests {
using namespace math;

/// x -> root(x), quotient(-3, x)
template <class P>
struct RootsAndQuotients {
  ArraySpan<P, typename P::real> x, roots, quotients;
  SCREE_FN void operator()(int i) const {
    using real = typename P::real;
    roots(i) = root(x(i));
    quotients(i) = x(i) > 0 ? quotient(real(-3), x(i)) : real(0);
  }
};

// The hardware's inverse root is accurate to two units; squaring doubles that, and each product adds half a unit.
TEMPLATE_LIST_TEST_CASE("roots and quotients are right to a few units in the last place", "", Policies) {
  using P = TestType;
  using real = typename P::real;
  std::vector<real> arguments{0, std::numeric_limits<real>::quiet_NaN()};
  for (int exponent = -30; exponent <= 30; exponent += 3)
    for (double const mantissa : {1.0, 1.1, 1.4142, 1.9999}) arguments.push_back(real(std::ldexp(mantissa, exponent)));
  auto const x = array_of<P>(arguments);
  auto const size = static_cast<std::size_t>(x.size());
  Array<P, real> const roots_there(x.space(), "scree::test::roots", size),
      quotients_there(x.space(), "scree::test::quotients", size);
  for_each_index(x.space(), "scree::test::root", 0, x.size(), RootsAndQuotients<P>{x, roots_there, quotients_there});
  auto const roots = values_of(roots_there), quotients = values_of(quotients_there);
  CHECK(roots[0] == 0);
  CHECK(std::isnan(roots[1]));
  for (std::size_t i = 2; i < size; ++i) {
    double const argument = double(arguments[i]);
    INFO(argument);
    CHECK(std::abs(double(roots[i]) / std::sqrt(argument) - 1) < ulps<P>(3));
    CHECK(std::abs(double(quotients[i]) / (-3 / argument) - 1) < ulps<P>(6));
  }
}

/// x -> ratio(-3, x), smaller(x, 0), magnitude(x)
template <class P>
struct RatiosAndOrder {
  ArraySpan<P, typename P::real> x, ratios, least, magnitudes;
  SCREE_FN void operator()(int i) const {
    using real = typename P::real;
    ratios(i) = ratio(real(-3), x(i));
    least(i) = smaller(x(i), real(0));
    magnitudes(i) = magnitude(x(i));
  }
};
TEMPLATE_LIST_TEST_CASE("ratios have divisors of either sign, and what is not a number is not the smaller one", "",
                        Policies) {
  using P = TestType;
  using real = typename P::real;
  real const infinite = std::numeric_limits<real>::infinity();
  std::vector<real> arguments{std::numeric_limits<real>::quiet_NaN(), infinite, -infinite};
  for (int exponent = -30; exponent <= 30; exponent += 3)
    for (double const mantissa : {1.0, -1.1, 1.4142, -1.9999})
      arguments.push_back(real(std::ldexp(mantissa, exponent)));
  auto const x = array_of<P>(arguments);
  auto const size = static_cast<std::size_t>(x.size());
  Array<P, real> const ratios_there(x.space(), "scree::test::ratios", size), least_there(x.space(), "least", size),
      magnitudes_there(x.space(), "scree::test::magnitudes", size);
  for_each_index(x.space(), "scree::test::ratio", 0, x.size(),
                 RatiosAndOrder<P>{x, ratios_there, least_there, magnitudes_there});
  auto const ratios = values_of(ratios_there), least = values_of(least_there), magnitudes = values_of(magnitudes_there);
  CHECK(std::isnan(ratios[0]));
  CHECK(least[0] == 0);
  CHECK(ratios[1] == 0);
  CHECK(ratios[2] == 0);
  CHECK(least[2] == -infinite);
  for (std::size_t i = 3; i < size; ++i) {
    double const argument = double(arguments[i]);
    INFO(argument);
    CHECK(std::abs(double(ratios[i]) / (-3 / argument) - 1) < ulps<P>(6));
    CHECK(least[i] == std::min(arguments[i], real(0)));
    CHECK(magnitudes[i] == std::abs(arguments[i]));
  }
}

}  // namespace scree::test::root_tests
