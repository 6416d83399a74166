// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/kernels/wendland_c2.hpp>

#include <support/quadrature.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <cmath>
#include <numbers>

namespace scree::test::wendland_c2_tests {
namespace {

struct LatticeSums {
  double value, moment;  // sum V W and sum V z dW/dz
};

// On a square lattice of spacing 1.
LatticeSums by_summation(double h) {
  KernelFunction<WendlandC2, 2, double> const W(h);
  LatticeSums sums{};
  for (int a = -4; a <= 4; ++a)
    for (int b = -4; b <= 4; ++b)
      if (double const r = std::hypot(a, b); r < W.radius()) {
        sums.value += W.value(r);
        sums.moment += b * b * W.slope_over_distance(r);
      }
  return sums;
}

// Poisson: a lattice sum of f is the sum of its Fourier transform over the reciprocal lattice, 2 pi times the integers.
// The transform of W is W^(k) = 2 pi int W J0(k r) r dr, that of z dW/dz is -(W^ + k_z dW^/dk_z), whose mean over the
// two axes is -(W^ + k W^'/2) with W^' = -2 pi int W J1(k r) r^2 dr. W^ falls as k^-5: the rings beyond 12 add about
// 12^-3 of the first ring's 5e-3 (moment: 3e-2). 60 nodes resolve k/2 <= 160/2 rad in each piece.
LatticeSums by_transform(double h) {
  using std::numbers::pi;
  auto const rule = gauss_legendre(60);
  double const factor = 2 * pi * WendlandC2::sigma<2>();
  LatticeSums sums{};
  for (int a = -12; a <= 12; ++a)
    for (int b = -12; b <= 12; ++b) {
      double const k = 2 * pi * h * std::hypot(a, b);
      auto const zeroth = [&](double q) { return factor * WendlandC2::w(q) * q * std::cyl_bessel_j(0.0, k * q); };
      auto const first = [&](double q) { return factor * WendlandC2::w(q) * q * q * std::cyl_bessel_j(1.0, k * q); };
      double const value = integrate_from_zero(2, zeroth, rule), slope = -integrate_from_zero(2, first, rule);
      sums.value += value;
      sums.moment -= value + k * slope / 2;
    }
  return sums;
}

}  // namespace

TEST_CASE("Wendland C2 has the lattice sums of its Fourier transform") {
  double const h = GENERATE(1.3, 1.5);
  CHECK(std::abs(by_summation(h).value - by_transform(h).value) < 1e-5);
  CHECK(std::abs(by_summation(h).moment - by_transform(h).moment) < 1e-4);
}

TEST_CASE("Wendland C2 has the published lattice sums") {
  // Lattice sums at h = 1.5 and 1.3 dr; derived in the test above.
  CHECK(std::abs(by_summation(1.5).value - 1.00514) < 5e-6);
  CHECK(std::abs(by_summation(1.5).moment + 0.99740) < 5e-6);
  CHECK(std::abs(by_summation(1.3).value - 1.01047) < 5e-6);
  CHECK(std::abs(by_summation(1.3).moment + 0.97392) < 5e-6);
}

}  // namespace scree::test::wendland_c2_tests
