// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/terms/laplacian.hpp>

#include <support/bodies.hpp>
#include <support/lattice_sums.hpp>
#include <support/quadrature.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <numbers>

namespace scree::test::laplacian_tests {
using namespace fields;
namespace {

using C = Concentration;
using D = Density;  // represents any coefficient

template <class P, class F, class G>
auto with_laplacian(double spacing, double ratio, F const& f, G const& g) {
  auto body = body_of<P, C, D, Laplacian<C, D>>(lattice<P::dim>(spacing), std::pow(spacing, P::dim));
  set(body, concentration, f);
  set(body, density, g);
  sum_over_itself(body, ratio * spacing, DoubleSumLaplacian<C, D>{});
  return body;
}

// The factor of div(g grad f). With f quadratic (Hessian H) and g linear, odd powers of x = x_i - x_j cancel on a
// lattice, as in the integrals of appendix D, and sum V (g_i + g_j)(f_i - f_j) (x . gradW) /(r^2 + eta^2) is -(g_i H +
// grad g (x) grad f) : sum V x (x) x (W'/r) r^2/(r^2 + eta^2) = factor (g tr H + grad g . grad f).
template <int Dim>
double lattice_factor(double ratio) {
  return -LatticeSums<Dim>(ratio).laplacian;
}
// The same with an integral instead of the sum, eta = h/10: the factor is less than 1 by int (-W' r)/Dim eta^2/(r^2 +
// eta^2) dV, in 2D about 5 (7/4) int_0^2 q (1 - q/2)^3 q^2/100/(q^2 + 1/100) dq = 8.75 (1/100) (1/5) less a tenth of
// it: 0.016.
template <int Dim>
double continuum_factor() {
  auto const shell = [](double q) { return std::pow(q, Dim + 1) * WendlandC2::dw_over_q(q) * q * q / (q * q + 0.01); };
  // Near q = 0.1 the integrand has poles off the axis; 60 nodes on [0, 1/2] resolve them.
  return -(Dim == 2 ? 2 : 4) * std::numbers::pi / Dim * WendlandC2::sigma<Dim>() *
         integrate_from_zero(2, shell, gauss_legendre(60));
}

}  // namespace

TEMPLATE_LIST_TEST_CASE(
    "the double-sum Laplacian of a quadratic field with a linear coefficient is exact up to a factor", "", Policies) {
  using P = TestType;
  constexpr int dim = P::dim;
  constexpr int z = dim - 1;
  double const spacing = 0.1, ratio = 1.5;
  auto const body = with_laplacian<P>(
      spacing, ratio,
      [](auto const& x) { return 0.1 + 0.5 * x[0] + x[0] * x[0] - 0.7 * x[0] * x[1] + 0.4 * x[z] * x[z]; },
      [](auto const& x) { return 1 + 0.8 * x[0] - 0.3 * x[z]; });
  double const factor = lattice_factor<dim>(ratio);
  auto const exact = [&](auto const& x) {
    double const f_x = 0.5 + 2 * x[0] - 0.7 * x[1], f_z = 0.8 * x[z] - (dim == 2 ? 0.7 * x[0] : 0.0);
    return factor * ((1 + 0.8 * x[0] - 0.3 * x[z]) * 2.8 + 0.8 * f_x - 0.3 * f_z);
  };
  auto const inside = [&](auto const& x) { return deep_inside<dim>(x, 2 * ratio * spacing - 0.04); };
  // Second differences over dr^2 = 1/100 of values of order one.
  CHECK(largest_error(body, laplacian<C, D>, 1, exact, inside) < ulps<P>(2e3));
}

TEST_CASE("the factor of the double-sum Laplacian tends to that of the continuum") {
  CHECK(std::abs(lattice_factor<2>(1.5) - 0.985) < 5e-4);       // the value noted for h = 1.5 dr in 2D
  CHECK(std::abs(continuum_factor<2>() - (1 - 0.016)) < 5e-4);  // by hand, see above
  double before = 1;
  for (double const ratio : {1.5, 3.0, 4.5, 6.0, 9.0}) {
    double const off = std::abs(lattice_factor<2>(ratio) / continuum_factor<2>() - 1);
    INFO("h/dr = " << ratio << ": " << off);
    CHECK(off < before);
    before = off;
  }
  CHECK(before < 2e-5);
  CHECK(std::abs(lattice_factor<3>(4.5) / continuum_factor<3>() - 1) < 1e-3);
}

TEMPLATE_LIST_TEST_CASE("the double-sum Laplacian is of second order but for its factor", "", DoublePolicies) {
  using P = TestType;
  constexpr int dim = P::dim;
  double const ratio = 1.5;
  auto const error = [&](double spacing) {
    auto const body = with_laplacian<P>(
        spacing, ratio, [](auto const& x) { return std::sin(2 * x[0] - x[1]); },
        [](auto const& x) { return std::exp(x[0]); });
    double const factor = lattice_factor<dim>(ratio);
    // div(g grad f) = g (lap f + f_x) with g = e^x.
    auto const exact = [&](auto const& x) {
      double const phase = 2 * x[0] - x[1];
      return factor * std::exp(x[0]) * (-5 * std::sin(phase) + 2 * std::cos(phase));
    };
    return largest_error(body, laplacian<C, D>, 1, exact, [](auto const& x) { return deep_inside<P::dim>(x, 0.33); });
  };
  double const order = std::log2(error(1.0 / 10) / error(1.0 / 20));
  INFO("order " << order);
  CHECK(order > 1.8);
}

TEMPLATE_LIST_TEST_CASE("the double-sum Laplacian moves nothing in or out", "", Policies) {
  using P = TestType;
  auto body = body_of<P, C, D, Laplacian<C, D>>(lattice<P::dim>(0.1, 0.2), std::pow(0.1, P::dim));
  set(body, concentration, [](auto const& x) { return std::cos(3 * x[0]) * x[1]; });
  set(body, density, [](auto const& x) { return 1 + x[0]; });
  sum_over_itself(body, 0.15, DoubleSumLaplacian<C, D>{});
  double sum = 0, magnitude = 0;
  for (auto const rate : body.to_host(laplacian<C, D>)) {
    sum += double(rate);
    magnitude += std::abs(double(rate));
  }
  CHECK(std::abs(sum) < ulps<P>(65) * magnitude);
  CHECK(magnitude > 1);
}

}  // namespace scree::test::laplacian_tests
