// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/terms/consistent_gradient.hpp>

#include <support/bodies.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>

namespace scree::test::consistent_gradient_tests {
using namespace fields;
namespace {

using C = Concentration;

template <class P>
auto with_gradient(Points<P::dim> const& points, double spacing, double ratio) {
  auto body = body_of<P, C, Gradient<C>>(points, std::pow(spacing, P::dim));
  set(body, concentration, [](auto const& x) { return 0.4 + 1.3 * x[0] - 0.6 * x[1] + 0.2 * x[P::dim - 1]; });
  body.fill(gradient<C>, value_t<P, Gradient<C>>::Constant(typename P::real(77)));
  double const h = ratio * spacing;
  sum_over_itself_then(body, h, ConsistentGradient<C>{h}, ConsistencyMatrixSum{}, ConsistencyVectorSum<C>{});
  return body;
}

template <int Dim>
Vec<Dim, double> exact_gradient() {
  Vec<Dim, double> result = Vec<Dim, double>::Zero();
  result[0] = 1.3;
  result[1] = -0.6;
  result[Dim - 1] += 0.2;
  return result;
}

// A jittered block with an inclined cut: faces, edges, corners and a wedge.
template <int Dim>
Points<Dim> truncated(double spacing) {
  auto points = lattice<Dim>(spacing, 0.1, 5);
  auto const outside = [](auto const& x) { return x[0] + 0.4 * x[Dim - 1] > 1.1; };
  points.erase(std::remove_if(points.begin(), points.end(), outside), points.end());
  return points;
}

}  // namespace

// Appendix E of Zhu et al. (2024).
TEMPLATE_LIST_TEST_CASE("the consistent gradient is exact for linear fields on truncated jittered sets", "", Policies) {
  using P = TestType;
  double const spacing = 0.1;
  for (double const ratio : {1.3, 1.5, 2.0}) {
    auto const body = with_gradient<P>(truncated<P::dim>(spacing), spacing, ratio);
    auto const exact = [](auto const&) { return exact_gradient<P::dim>(); };
    INFO("h/dr = " << ratio);
    // Round-off of differences of order dr, over dr, times the condition of the matrix (about 100 in a corner).
    CHECK(largest_error(body, gradient<C>, 1, exact) < ulps<P>(3e3));
  }
}

TEMPLATE_LIST_TEST_CASE("neighbours that do not span the space give no gradient", "", Policies) {
  using P = TestType;
  constexpr int dim = P::dim;
  auto const none = [](auto const& x) { return (0 * x).eval(); };
  Points<dim> line, plane;
  for (int k = 0; k < 9; ++k) line.push_back(0.1 * k * Vec<dim, double>::Unit(1));
  for (int k = 0; k < 49; ++k)
    plane.push_back(0.1 * (k % 7) * Vec<dim, double>::Unit(0) + 0.1 * (k / 7) * Vec<dim, double>::Unit(dim - 1));
  CHECK(largest_error(with_gradient<P>({Vec<dim, double>::Constant(0.5)}, 0.1, 1.5), gradient<C>, 1, none) == 0);
  CHECK(largest_error(with_gradient<P>(line, 0.1, 1.5), gradient<C>, 1, none) == 0);
  if (dim == 3) CHECK(largest_error(with_gradient<P>(plane, 0.1, 1.5), gradient<C>, 1, none) == 0);
}

TEMPLATE_LIST_TEST_CASE("the consistent gradient of a constant is zero to the last bit", "", Policies) {
  using P = TestType;
  auto body = body_of<P, C, Gradient<C>>(truncated<P::dim>(0.1), std::pow(0.1, P::dim));
  body.fill(concentration, typename P::real(0.3));
  sum_over_itself_then(body, 0.15, ConsistentGradient<C>{0.15}, ConsistencyMatrixSum{}, ConsistencyVectorSum<C>{});
  CHECK(largest_error(body, gradient<C>, 1, [](auto const& x) { return (0 * x).eval(); }) == 0);
}

}  // namespace scree::test::consistent_gradient_tests
