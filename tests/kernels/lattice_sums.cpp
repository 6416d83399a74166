// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "all.hpp"

#include <support/lattice_sums.hpp>
#include <support/quadrature.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <numbers>

namespace scree::test::lattice_sums_tests {
namespace {

template <class K, int Dim>
double lattice_sum_by_hand(double spacing) {
  // The support includes the nearest neighbours, at the distance `spacing`, but not those on the diagonal.
  double const sigma = K::template sigma<Dim>();
  return std::pow(spacing, Dim) * sigma * (K::w(0.0) + 2 * Dim * K::w(spacing));
}
template <class K, int Dim>
double plane_integral() {
  auto const shell = [](double q) { return std::pow(q, Dim - 2) * K::w(q); };
  return (Dim == 2 ? 2 : 2 * std::numbers::pi) * K::template sigma<Dim>() * integrate_from_zero(K::support, shell);
}
template <class K, int Dim, class Real>
double asymmetry_of(double h) {
  return surface_asymmetry(KernelFunction<K, Dim, Real>(h));
}
template <int Dim, class Real>
double lattice_sum_of(double h, double spacing) {
  return kernel_sum_of_lattice(KernelFunction<WendlandC2, Dim, Real>(h), spacing);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("the kernel sum of a coarse lattice is that of the nearest neighbours", "", Kernels) {
  double const spacing = 0.8 * TestType::support;
  KernelFunction<TestType, 2, double> const plane(1);
  KernelFunction<TestType, 3, double> const space(1);
  CHECK(std::abs(kernel_sum_of_lattice(plane, spacing) / lattice_sum_by_hand<TestType, 2>(spacing) - 1) < 1e-14);
  CHECK(std::abs(kernel_sum_of_lattice(space, spacing) / lattice_sum_by_hand<TestType, 3>(spacing) - 1) < 1e-14);
}

TEST_CASE("the kernel sum of a lattice has all of its points once, in any unit and precision") {
  for (double const h : {1.1, 1.5, 2.3}) {
    INFO("h " << h);
    CHECK(std::abs(lattice_sum_of<2, double>(h, 1) - LatticeSums<2>(h).value) < 1e-14);
    CHECK(std::abs(lattice_sum_of<3, double>(h, 1) - LatticeSums<3>(h).value) < 1e-14);
    CHECK(std::abs(lattice_sum_of<3, double>(h * 2e-3, 2e-3) - LatticeSums<3>(h).value) < 1e-13);
    CHECK(std::abs(lattice_sum_of<3, float>(h * 2e-3, 2e-3) - LatticeSums<3>(h).value) < 2e-6);  // some 20 ulps
  }
}

TEST_CASE("the kernel sum of a fine lattice approaches one") {
  // The sum is the trapezoidal rule. Its error is the Fourier transform of the kernel at the reciprocal lattice, which
  // for Wendland's C2 falls as (h/spacing)^-(dim + 3).
  double const plane = std::abs(lattice_sum_of<2, double>(1.5, 1) - 1), space = lattice_sum_of<3, double>(1.5, 1) - 1;
  CHECK(plane < 0.01);
  CHECK(std::abs(lattice_sum_of<2, double>(6, 1) - 1) < 3 * plane * std::pow(4.0, -5));
  CHECK(std::abs(space) < 0.01);
  CHECK(std::abs(lattice_sum_of<3, double>(6, 1) - 1) < 1e-4);
}

TEMPLATE_LIST_TEST_CASE("the asymmetry at a surface is the kernel integrated over it", "", Kernels) {
  // Midpoint rule of 1000 intervals: (1/24) (2/1000)^2 times the difference of the slopes at the ends, which is at most
  // that of r W in 3D at the centre, of order one.
  for (double const h : {0.01, 1.0, 7.0}) {
    INFO("h " << h);
    CHECK(std::abs(asymmetry_of<TestType, 2, double>(h) - plane_integral<TestType, 2>()) < 1e-6);
    CHECK(std::abs(asymmetry_of<TestType, 3, double>(h) - plane_integral<TestType, 3>()) < 1e-6);
    CHECK(std::abs(asymmetry_of<TestType, 3, float>(h) - plane_integral<TestType, 3>()) < 1e-5);
  }
}

TEST_CASE("the asymmetry at a surface of Wendland's kernel is 7/(3 pi) and 3/4") {
  // With t = q/2: int (1 - t)^4 (1 + 4 t) dt = 1/5 + 4/30 = 1/3, so 2D 2 (7/(4 pi)) 2/3; int t (1 - t)^4 (1 + 4 t) dt =
  // 1/30 + 4/105 = 1/14, so 3D 2 pi (21/(16 pi)) 4/14.
  CHECK(std::abs(asymmetry_of<WendlandC2, 2, double>(1) - 7 / (3 * std::numbers::pi)) < 1e-9);
  CHECK(std::abs(asymmetry_of<WendlandC2, 3, double>(1) - 0.75) < 1e-6);
}

TEST_CASE("the asymmetry at a surface is the largest that a half-space of particles shows") {
  double const dr = 0.05, h = 1;  // 20 particles per h: the sums below are integrals within about 1 %
  KernelFunction<WendlandC2, 2, double> const W(h);
  double largest = 0, at = 1;
  for (double above = -1; above <= 1; above += dr) {  // height of the surface above the particle
    double sum = 0;
    for (double x = -2; x <= 2; x += dr)
      for (double z = above - dr / 2; z > -2; z -= dr)
        if (double const r = std::hypot(x, z); r < W.radius()) sum += sq(dr) * h * W.slope_over_distance(r) * -z;
    if (std::abs(sum) > largest) largest = std::abs(sum), at = above;
  }
  CHECK(std::abs(largest / surface_asymmetry(W) - 1) < 0.01);
  CHECK(std::abs(at) < 1.5 * dr);
}

}  // namespace scree::test::lattice_sums_tests
