// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/volume_control.hpp>
#include <scree/kernels/wendland_c2.hpp>

#include <support/quadrature.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scree::test::compactness_tests {
namespace {

/// Sums over a lattice below a plane surface for a particle of unit volume in row `row` below the surface, 0 the
/// uppermost.
struct Seen {
  double phi = 0, gradient = 0;
};
template <int Dim>
Seen half_space(KernelFunction<WendlandC2, Dim, double> const& W, double spacing, int row) {
  Seen seen;
  int const n = 4, depth = Dim == 3 ? n : 0;
  for (int a = -n; a <= n; ++a)
    for (int b = -depth; b <= depth; ++b)
      for (int c = -n; c <= std::min(row, n); ++c) {
        double const r = spacing * std::sqrt(double(a * a + b * b + c * c));
        if (r >= W.radius()) continue;
        seen.phi += W.value(r);
        seen.gradient += W.h() * W.slope_over_distance(r) * -spacing * c;
      }
  return {seen.phi, std::abs(seen.gradient)};
}

/// Largest relative error of the compactness in a row, against that of a full support.
template <int Dim>
double error_in_row(double spacing, int row) {
  KernelFunction<WendlandC2, Dim, double> const W(1.5);
  Seen const there = half_space<Dim>(W, spacing, row), inside = half_space<Dim>(W, spacing, 100);
  return std::abs(compactness(there.phi, there.gradient, surface_asymmetry(W)) / inside.phi - 1);
}

/// The kernel integrated over a plane at a distance, both in h; with t^2 = q^2 - s^2, dq = t/q dt.
template <int Dim>
double over_plane(double s) {
  auto const ring = [&](double t) {
    return std::pow(t, Dim - 2) * WendlandC2::w(std::min(2.0, std::sqrt(s * s + t * t)));
  };
  double const edge = std::sqrt(4 - s * s);
  auto const scaled = [&](double part) { return edge / 2 * ring(edge / 2 * part); };
  return (Dim == 2 ? 2 : 2 * std::numbers::pi) * WendlandC2::sigma<Dim>() * integrate_from_zero(2, scaled);
}
/// Largest error of the compactness for half-spaces of any density.
template <int Dim>
double error_at_integrated_surfaces() {
  double worst = 0, deepest = 0.5;  // Phi at the surface itself: half of the support
  for (double s = 0; s < 2; s += 0.01) {
    for (double const c : {0.7, 1.0, 1.1}) {
      double const found = compactness(c * deepest, c * over_plane<Dim>(s), over_plane<Dim>(0));
      worst = std::max(worst, std::abs(found / c - 1));
    }
    deepest += 0.01 * over_plane<Dim>(s + 0.005);
  }
  CHECK(std::abs(deepest - 1) < 1e-5);  // the kernel integrates to one
  return worst;
}

}  // namespace

TEST_CASE("the compactness of a lattice below a plane surface is that inside") {
  for (int row = 0; row <= 3; ++row)
    for (double const spacing : {1.0, 1.05}) {
      INFO("row " << row << ", spacing " << spacing << ": errors " << error_in_row<2>(spacing, row) << " in 2D, "
                  << error_in_row<3>(spacing, row) << " in 3D");
      CHECK(error_in_row<2>(spacing, row) < (row == 0 ? 0.035 : 0.005));
      CHECK(error_in_row<3>(spacing, row) < (row == 0 ? 0.035 : 0.005));
    }
  // Rows 2 and 3 have a full support. In row 0 the error is about the difference between sums and integrals. The
  // densities to be distinguished differ by 10 %, and row 0 lacks 25 %.
  KernelFunction<WendlandC2, 2, double> const W(1.5);
  CHECK(std::abs(half_space<2>(W, 1.05, 100).phi * sq(1.05) - 1) < 0.01);
  CHECK(half_space<2>(W, 1, 0).phi < 0.76);
}

TEST_CASE("the compactness of an integrated half-space is its density") {
  INFO(error_at_integrated_surfaces<2>() << " " << error_at_integrated_surfaces<3>());
  CHECK(error_at_integrated_surfaces<2>() < 0.005);
  CHECK(error_at_integrated_surfaces<3>() < 0.005);
}

TEST_CASE("the compactness is the number density where nothing is missing, and at most twice that") {
  for (double const phi : {0.0, 0.25, 0.9, 1.0, 1.2}) CHECK((compactness(phi, 0.0, 0.743) == phi || phi == 0));
  CHECK(compactness(0.987f, 0.0f, 0.743f) == 0.987f);
  for (double phi = 0; phi < 1.3; phi += 0.1)
    for (double gradient = 0; gradient < 2; gradient += 0.05) {
      double const c = compactness(phi, gradient, 0.743);
      CHECK((c >= phi && c <= (2 + 1e-12) * phi));  // not for a NaN
    }
}

}  // namespace scree::test::compactness_tests
