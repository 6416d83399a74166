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

}  // namespace scree::test::root_tests
