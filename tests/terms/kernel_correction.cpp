// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/terms/kernel_correction.hpp>

#include <scree/terms/velocity_gradient.hpp>

#include <support/bodies.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>

namespace scree::test::kernel_correction_tests {
using namespace fields;
namespace {

template <int Dim>
Points<Dim> truncated() {
  auto points = lattice<Dim>(0.125, 0.1, 5);
  auto const outside = [](auto const& x) { return x[0] + 0.4 * x[Dim - 1] > 1.1; };
  points.erase(std::remove_if(points.begin(), points.end(), outside), points.end());
  return points;
}
template <int Dim>
Mat<Dim, double> some_gradient() {
  Mat<Dim, double> L;
  for (int k = 0; k < Dim * Dim; ++k) L.data()[k] = std::sin(1.0 + 3 * k);
  return L;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("corrected gradients are exact for linear fields at truncated supports", "", Policies) {
  using P = TestType;
  auto const L = some_gradient<P::dim>();
  auto body = body_of<P, Concentration, Gradient<Concentration>, Velocity, VelocityGradient>(truncated<P::dim>(),
                                                                                             std::pow(0.125, P::dim));
  set(body, concentration, [&](auto const& x) { return L.row(0).dot(x); });
  set(body, velocity, [&](auto const& x) { return (L * x).eval(); });
  sum_over_itself_then(body, 0.1875, CorrectedGradient<Concentration>{}, PlainGradient<Concentration>{},
                       FirstMomentSum{});
  sum_over_itself_then(body, 0.1875, CorrectedVelocityGradient{}, VelocityGradientSum{}, FirstMomentSum{});
  auto const slope = [&](auto const&) { return L.row(0).transpose().eval(); };
  CHECK(largest_error(body, gradient<Concentration>, 1, slope) < ulps<P>(1e3));
  CHECK(largest_error(body, velocity_gradient, 1, [&](auto const&) { return L; }) < ulps<P>(1e3));
}

TEST_CASE("neighbours that do not span the space leave the plain gradient") {
  Vec<2, double> const plain(1, 2);
  Mat<2, double> line = Mat<2, double>::Zero();
  line(0, 0) = -1;
  CHECK(corrected_gradient(plain, line) == plain);
  CHECK(corrected_gradient(plain, Mat<2, double>(-2 * Mat<2, double>::Identity())) == plain / 2);
}

}  // namespace scree::test::kernel_correction_tests
