// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "all.hpp"

#include <scree/core/pack.hpp>

#include <support/quadrature.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <numbers>
#include <type_traits>

namespace scree::test::kernel_tests {
namespace {

constexpr double surface_of_unit_sphere[] = {0, 2, 2 * std::numbers::pi, 4 * std::numbers::pi};

template <class K, int Dim>
double mass() {
  auto const shell = [](double q) { return std::pow(q, Dim - 1) * K::w(q); };
  return surface_of_unit_sphere[Dim] * K::template sigma<Dim>() * integrate_from_zero(K::support, shell);
}

// int x_a dW/dx_a dV, by parts: -1 and the surface term of a kernel that is cut off.
template <class K, int Dim>
double first_moment_of_gradient() {
  auto const shell = [](double q) { return std::pow(q, Dim + 1) * K::dw_over_q(q); };
  double const integral = integrate_from_zero(K::support, shell);
  double const cut = std::pow(K::support, Dim) * K::w(double(K::support));
  return surface_of_unit_sphere[Dim] / Dim * K::template sigma<Dim>() * (integral - cut);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("a kernel is a SmoothingKernel and integrates to one", "", Kernels) {
  STATIC_CHECK(SmoothingKernel<TestType>);
  CHECK(std::abs(mass<TestType, 1>() - 1) < 1e-14);
  CHECK(std::abs(mass<TestType, 2>() - 1) < 1e-14);
  CHECK(std::abs(mass<TestType, 3>() - 1) < 1e-14);
}

TEMPLATE_LIST_TEST_CASE("the gradient of a kernel has the first moment minus one", "", Kernels) {
  CHECK(std::abs(first_moment_of_gradient<TestType, 1>() + 1) < 1e-14);
  CHECK(std::abs(first_moment_of_gradient<TestType, 2>() + 1) < 1e-14);
  CHECK(std::abs(first_moment_of_gradient<TestType, 3>() + 1) < 1e-14);
}

TEMPLATE_LIST_TEST_CASE("the derivative of a kernel is that of finite differences", "", Kernels) {
  // Fourth-order differences with a step that does not reach the knots, which are at multiples of 1/2. Error: step^4
  // w'''''/30 < 1e-12 * 1e3 for the quintic, and round-off 1e-16 w(0)/step.
  double const step = 1e-3, scale = TestType::w(0.0);
  double worst = 0;
  for (double q = 1.0 / 128; q < TestType::support; q += 1.0 / 64) {
    double const near = TestType::w(q + step) - TestType::w(q - step);
    double const far = TestType::w(q + 2 * step) - TestType::w(q - 2 * step);
    worst = std::max(worst, std::abs((8 * near - far) / (12 * step) - q * TestType::dw_over_q(q)));
  }
  CHECK(worst < 1e-10 * scale);
}

TEMPLATE_LIST_TEST_CASE("the derivative of a kernel over q is finite at zero", "", Kernels) {
  // w is even up to |q|^3, so that 2 (w(s) - w(0))/s^2 = w''(0) + O(s).
  double const s = 1e-5;
  double const curvature = 2 * (TestType::w(s) - TestType::w(0.0)) / (s * s);
  CHECK(std::abs(TestType::dw_over_q(0.0) - curvature) < 1e-4 * TestType::w(0.0));
}

TEMPLATE_LIST_TEST_CASE("a kernel falls from its centre to zero at its support", "", Kernels) {
  bool falls = true, positive = true;
  for (double q = 0; q < TestType::support; q += 1.0 / 256) {
    falls = falls && TestType::dw_over_q(q) < 0;
    positive = positive && TestType::w(q) > 0;
  }
  CHECK(falls);
  CHECK(positive);
  double const end = TestType::support;
  if constexpr (std::is_same_v<TestType, Gaussian>) {
    CHECK(std::abs(TestType::w(end) - std::exp(-9.0)) < 1e-18);  // the only one that is cut off
  } else {
    CHECK(TestType::w(end) == 0);
    CHECK(TestType::dw_over_q(end) == 0);
  }
}

TEMPLATE_LIST_TEST_CASE("a kernel and its derivative are continuous at the knots", "", Kernels) {
  double const step = 1e-9, scale = TestType::w(0.0);
  for (double knot = 0.5; knot < TestType::support; knot += 0.5) {
    CHECK(std::abs(TestType::w(knot + step) - TestType::w(knot - step)) < 1e-8 * scale);
    CHECK(std::abs(TestType::dw_over_q(knot + step) - TestType::dw_over_q(knot - step)) < 1e-7 * scale);
  }
}

TEMPLATE_LIST_TEST_CASE("a kernel in float agrees with the one in double", "", Kernels) {
  // Truncated powers cancel: (3 - q)^5 <= 243 at w(0) = 66, a few ulps (1.2e-7) of that.
  double value = 0, slope = 0;
  for (float q = 0; q <= float(TestType::support); q += 1.0f / 128) {
    value = std::max(value, std::abs(double(TestType::w(q)) - TestType::w(double(q))));
    slope = std::max(slope, std::abs(double(TestType::dw_over_q(q)) - TestType::dw_over_q(double(q))));
  }
  CHECK(value < 2e-6 * TestType::w(0.0));
  CHECK(slope < 4e-6 * std::abs(TestType::dw_over_q(0.0)));
}

#ifdef SCREE_HAS_PACKS
namespace {
/// Largest difference; NaN if one is NaN.
double larger(double difference, double so_far) { return difference <= so_far ? so_far : difference; }

template <class K, class Real>
void check_packs() {
  using Lanes = Pack<Real>;
  double value = 0, slope = 0;
  for (double q = 0; q < K::support; q += 1.0 / 64) {
    // Zero and numbers on either side of a knot in one pack.
    auto const number = [&](int lane) { return Real(lane == 0 ? q : std::fmod(q + 0.7 * lane, K::support)); };
    auto const w = K::w(Lanes::of(number)), dw_over_q = K::dw_over_q(Lanes::of(number));
    for (int lane = 0; lane < Lanes::size; ++lane) {
      value = larger(double(std::abs(w[lane] - K::w(number(lane)))), value);
      slope = larger(double(std::abs(dw_over_q[lane] - K::dw_over_q(number(lane)))), slope);
    }
  }
  // A compiler may contract products and sums in one and not in the other; (3 - q)^5 <= 243 at w(0) = 66.
  double const tolerance = 30 * double(std::numeric_limits<Real>::epsilon());
  CHECK(value < tolerance * K::w(0.0));
  CHECK(slope < tolerance * std::abs(K::dw_over_q(0.0)));
}
}  // namespace

TEMPLATE_LIST_TEST_CASE("a kernel of packs is that of numbers", "", Kernels) {
  STATIC_CHECK(takes_packs<TestType>);
  check_packs<TestType, float>();
  check_packs<TestType, double>();
}
#endif

namespace {
template <class K, int Dim, class Real>
void check_function() {
  double const h = 0.3, r = 0.17;
  KernelFunction<K, Dim, Real> const W(h);
  double const tolerance = 20 * double(std::numeric_limits<Real>::epsilon());
  CHECK(W.h() == Real(h));
  CHECK(std::abs(double(W.radius()) - K::support * h) < tolerance);
  double const value = K::template sigma<Dim>() / std::pow(h, Dim) * K::w(r / h);
  CHECK(std::abs(double(W.value(Real(r))) - value) < tolerance * value);
  // dW/dr = sigma/h^(Dim + 1) dw/dq, so (dW/dr)/r has two powers of h more than W.
  double const slope = K::template sigma<Dim>() / std::pow(h, Dim + 2) * K::dw_over_q(r / h);
  CHECK(std::abs(double(W.slope_over_distance(Real(r))) - slope) < tolerance * std::abs(slope));
}
}  // namespace

TEMPLATE_LIST_TEST_CASE("a kernel function scales with the smoothing length", "", Kernels) {
  check_function<TestType, 1, double>();
  check_function<TestType, 2, double>();
  check_function<TestType, 3, double>();
  check_function<TestType, 2, float>();
  check_function<TestType, 3, float>();
}

}  // namespace scree::test::kernel_tests
