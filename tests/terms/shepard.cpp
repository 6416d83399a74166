// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/terms/shepard.hpp>

#include <support/bodies.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

namespace scree::test::shepard_tests {
using namespace fields;
namespace {

using C = Concentration;
constexpr Smoothed<C> smoothed{};

template <class P, class Function>
auto with_mean(Points<P::dim> const& points, Function const& f) {
  auto body = body_of<P, C, Smoothed<C>>(points, std::pow(0.1, P::dim));
  set(body, concentration, f);
  sum_over_itself_then(body, 0.15, ShepardMean<C>{}, ShepardSums<C>{});
  return body;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("the Shepard mean of a constant is that constant, also at an edge", "", Policies) {
  using P = TestType;
  auto const body = with_mean<P>(lattice<P::dim>(0.1, 0.3), [](auto const&) { return 0.7; });
  CHECK(largest_error(body, smoothed, 1, [](auto const&) { return 0.7; }) < ulps<P>(20));
}

TEMPLATE_LIST_TEST_CASE("the Shepard mean of a linear field is that field in the middle of a lattice", "", Policies) {
  using P = TestType;
  auto const linear = [](auto const& x) { return 0.2 + 0.5 * x[0] - 0.1 * x[1]; };
  auto const body = with_mean<P>(lattice<P::dim>(0.1), linear);
  auto const inside = [](auto const& x) { return deep_inside<P::dim>(x, 0.26); };
  CHECK(largest_error(body, smoothed, 1, linear, inside) < ulps<P>(40));
}

TEMPLATE_LIST_TEST_CASE("a Shepard mean stays between the values around it", "", Policies) {
  using P = TestType;
  auto const body = with_mean<P>(lattice<P::dim>(0.1, 0.3), [](auto const& x) { return x[0] > 0.5 ? 1.0 : 0.0; });
  for (auto const mean : body.to_host(smoothed)) {
    REQUIRE(double(mean) >= 0);
    REQUIRE(double(mean) <= 1 + ulps<P>(20));
  }
}

TEMPLATE_LIST_TEST_CASE("the Shepard mean of a lone particle is its own value", "", Policies) {
  using P = TestType;
  auto const body = with_mean<P>({Vec<P::dim, double>::Constant(0.5)}, [](auto const&) { return 0.3; });
  CHECK(std::abs(double(body.to_host(smoothed)[0]) - 0.3) < ulps<P>(4));
}

}  // namespace scree::test::shepard_tests
