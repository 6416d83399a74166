// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception

#include "../../../../examples/shear_box/reference/exact.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>

namespace scree::test::exact_series_tests {
using namespace shear_box::reference;
using Catch::Matchers::WithinAbs;

namespace {

// f', fourth order in the step.
template <class F>
double derivative(const F& f, double x, double step) {
  return (8.0 * (f(x + step) - f(x - step)) - (f(x + 2.0 * step) - f(x - 2.0 * step))) / (12.0 * step);
}

// V C (1 - C) + D C_z
double flux(ExactSeries const& exact, Coefficients c, double z, double t) {
  double const C = exact(z, t);
  return c.velocity * C * (1.0 - C) + c.diffusivity * derivative([&](double at) { return exact(at, t); }, z, 2e-4);
}

// C_t - (V C (1 - C) + D C_z)_z
double residual(ExactSeries const& exact, Coefficients c, double z, double t) {
  return derivative([&](double at) { return exact(z, at); }, t, 2e-3 * t) -
         derivative([&](double at) { return flux(exact, c, at, t); }, z, 1e-3);
}

double integral(ExactSeries const& exact, double t) {
  constexpr int cells = 20000;
  double sum = 0.0;
  for (int i = 0; i < cells; ++i) sum += exact((i + 0.5) / cells, t);
  return sum / cells;
}

}  // namespace

TEST_CASE("exact series: satisfies the equation") {
  Coefficients const c = GENERATE(reading_a, reading_b);
  ExactSeries const exact(c);
  double const t = GENERATE(5.0, 20.0, 40.0, 80.0);
  for (double z : {0.07, 0.2, 0.45, 0.5, 0.61, 0.85, 0.95})
    CHECK_THAT(residual(exact, c, z, t), WithinAbs(0.0, 2e-7));  // its terms are of the order of 0.01
}

TEST_CASE("exact series: no flux through bottom and top") {
  Coefficients const c = GENERATE(reading_a, reading_b);
  ExactSeries const exact(c);
  for (double t : {5.0, 20.0, 40.0, 80.0})
    for (double z : {0.0, 1.0}) CHECK_THAT(flux(exact, c, z, t), WithinAbs(0.0, 1e-10));  // V/4 ~ 0.005 at its largest
}

TEST_CASE("exact series: starts with small grains above large ones") {
  ExactSeries const exact(reading_a);
  CHECK(exact(0.4, 0.0) == 0.0);
  CHECK(exact(0.6, 0.0) == 1.0);
  constexpr double t = 1e-5;  // diffusion alone: the error function with a front of sqrt(4 D t) ~ 1e-4
  double const front = std::sqrt(4.0 * reading_a.diffusivity * t);
  for (double s : {-3.0, -1.0, -0.3, 0.0, 0.5, 2.0})
    CHECK_THAT(exact(0.5 + s * front, t), WithinAbs(0.5 * (1.0 + std::erf(s)), 1e-3));
  for (double z : {0.0, 0.25, 0.49}) {
    CHECK_THAT(exact(z, t), WithinAbs(0.0, 1e-7));
    CHECK_THAT(exact(1.0 - z, t), WithinAbs(1.0, 1e-7));
  }
}

TEST_CASE("exact series: keeps half of the grains small, ends at the steady state, stays in [0, 1]") {
  Coefficients const c = GENERATE(reading_a, reading_b);
  ExactSeries const exact(c);
  for (double t : {1.0, 20.0, 80.0, 1000.0})
    CHECK_THAT(integral(exact, t), WithinAbs(0.5, 1e-11));  // the sum's cancellation leaves ten digits
  for (double z = 0.0; z <= 1.0; z += 0.01) {
    CHECK_THAT(exact(z, 1000.0), WithinAbs(1.0 / (1.0 + std::exp(c.peclet() * (z - 0.5))), 1e-9));
    CHECK(exact(z, 3.0) > -1e-9);
    CHECK(exact(z, 3.0) < 1.0 + 1e-9);
  }
}

TEST_CASE("exact series: large Peclet numbers do not overflow, larger ones are rejected") {
  ExactSeries const sharp({.velocity = 0.1, .diffusivity = 1e-3});
  CHECK_THAT(integral(sharp, 5.0), WithinAbs(0.5, 1e-6));
  CHECK_THAT(sharp(0.3, 1e6), WithinAbs(1.0, 1e-8));
  CHECK_THAT(sharp(0.7, 1e6), WithinAbs(0.0, 1e-8));
  CHECK_THROWS(ExactSeries({.velocity = 0.2, .diffusivity = 1e-3}));
  CHECK_THROWS(ExactSeries({.velocity = 0.0, .diffusivity = 1e-3}));
}

TEST_CASE("exact series: what is left out is below rounding") {
  ExactSeries const exact(reading_a);
  CHECK(exact.terms(80.0) < 30);
  CHECK(exact.terms(1.0) > 50);
  double const t = GENERATE(1e-3, 1.0, 80.0);
  double const a = (2 * exact.terms(t) + 1) * std::acos(-1.0);  // of the first term left out, whose slope is
  double const k = 0.5 * reading_a.peclet();                    // 4 k a/(k^2 + a^2) exp(-D a^2 t) at most
  CHECK(4.0 * k * a / (k * k + a * a) * std::exp(-reading_a.diffusivity * a * a * t) < 1e-18);
}

}  // namespace scree::test::exact_series_tests
