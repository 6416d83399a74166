// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/terms/velocity_gradient.hpp>

#include <support/bodies.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>

namespace scree::test::velocity_gradient_tests {
using namespace fields;
namespace {

template <int Dim>
Mat<Dim, double> deformation() {
  Mat<Dim, double> L = Mat<Dim, double>::Zero();
  L(0, 0) = 0.3;
  L(0, Dim - 1) = 1.7;
  L(1, 0) = -0.4;
  L(Dim - 1, Dim - 1) -= 0.3;
  return L;
}

template <class P>
auto with_shear_rate(Points<P::dim> const& points, Mat<P::dim, double> const& L) {
  auto body = body_of<P, Velocity, ShearRate>(points, std::pow(0.1, P::dim));
  set(body, velocity, [&](auto const& x) { return (L * x).eval(); });
  sum_over_itself_then(body, 0.15, CorrectedShearRate{}, VelocityGradientSum{}, FirstMomentSum{});
  return body;
}

}  // namespace

TEST_CASE("the shear rate of simple shear is its rate, of a rotation zero") {
  Mat<2, double> shear = Mat<2, double>::Zero(), spin = shear;
  shear(0, 1) = 2.5;
  spin(0, 1) = 3;
  spin(1, 0) = -3;
  CHECK(std::abs(shear_rate_of(shear) - 2.5) < 1e-15);
  CHECK(shear_rate_of(spin) == 0);
  CHECK(shear_rate_of(Mat<3, double>(4 * Mat<3, double>::Identity())) < 1e-7);
  // Plane strain: e = diag(1, 1, 0) has the deviator diag(1, 1, -2)/3, so sqrt(2 e:e) = sqrt(2 * 6/9).
  CHECK(std::abs(shear_rate_of(Mat<2, double>(Mat<2, double>::Identity())) - std::sqrt(4.0 / 3)) < 1e-15);
}

TEMPLATE_LIST_TEST_CASE("the corrected shear rate is exact for affine velocities at truncated supports", "", Policies) {
  using P = TestType;
  constexpr int dim = P::dim;
  auto points = lattice<dim>(0.1, 0.1, 5);
  auto const outside = [](auto const& x) { return x[0] + 0.4 * x[dim - 1] > 1.1; };
  points.erase(std::remove_if(points.begin(), points.end(), outside), points.end());
  double const exact = shear_rate_of(deformation<dim>());
  auto const body = with_shear_rate<P>(points, deformation<dim>());
  CHECK(largest_error(body, shear_rate, exact, [&](auto const&) { return exact; }) < ulps<P>(1e3));
}

TEMPLATE_LIST_TEST_CASE("the velocity gradient has the velocity's component first", "", Policies) {
  using P = TestType;
  constexpr int dim = P::dim;
  auto body = body_of<P, Velocity, VelocityGradient, FirstMoment>(lattice<dim>(0.1), std::pow(0.1, dim));
  set(body, velocity, [&](auto const& x) { return (deformation<dim>() * x).eval(); });
  sum_over_itself(body, 0.15, VelocityGradientSum{}, FirstMomentSum{});
  auto const x = body.to_host(position);
  auto const gradients = body.to_host(velocity_gradient);
  auto const moments = body.to_host(first_moment);
  double error = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!deep_inside<dim>(x[i].template cast<double>(), 0.26)) continue;
    // L = -A M for u = A x, with M = -m I on a lattice (m = 0.99740 in 2D).
    Mat<dim, double> const M = moments[i].template cast<double>();
    error = std::max(error, (gradients[i].template cast<double>() + deformation<dim>() * M).norm());
    error = std::max(error, (M - M(0, 0) * Mat<dim, double>::Identity()).norm());
    error = std::max(error, std::abs(M(0, 0) + 1) > 0.02 ? 1.0 : 0.0);
  }
  CHECK(error < ulps<P>(100));
}

TEMPLATE_LIST_TEST_CASE("a particle without neighbours has no shear rate", "", Policies) {
  using P = TestType;
  auto const body = with_shear_rate<P>({Vec<P::dim, double>::Constant(0.5)}, deformation<P::dim>());
  CHECK(body.to_host(shear_rate)[0] == 0);
}

}  // namespace scree::test::velocity_gradient_tests
