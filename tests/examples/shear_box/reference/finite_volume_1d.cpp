// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception

#include "../../../../examples/shear_box/reference/finite_volume_1d.hpp"
#include "../../../../examples/shear_box/reference/exact.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <algorithm>
#include <cmath>

namespace scree::test::finite_volume_1d_tests {
using namespace shear_box::reference;
using Catch::Matchers::WithinAbs;
using shear_box::reference::SegregationFlux, shear_box::reference::ShearRateClosure;  // the library has such names

namespace {

double mean_absolute_error(Profile const& profile, ExactSeries const& exact, double t) {
  double error = 0.0;
  for (int i = 0; i < profile.cells(); ++i) error += std::abs(profile.values[i] - exact(profile.centre(i), t));
  return error / profile.cells();
}

double largest_difference(Profile const& a, Profile const& b) {
  double difference = 0.0;
  for (int i = 0; i < a.cells(); ++i) difference = std::max(difference, std::abs(a.values[i] - b.values[i]));
  return difference;
}

template <class Closure>
void check_bounded_and_conservative(Problem<Closure> const& problem, int cells) {
  for (Profile const& profile : solve_1d(problem, {0.01, 1.0, 10.0, 30.3, 60.0}, cells)) {
    CHECK(*std::min_element(profile.values.begin(), profile.values.end()) >= 0.0);
    CHECK(*std::max_element(profile.values.begin(), profile.values.end()) <= 1.0);
    CHECK_THAT(profile.mean(), WithinAbs(0.5, 1e-13));
  }
}

constexpr Coefficients nearly_no_diffusion{.velocity = 0.03, .diffusivity = 1e-6};

}  // namespace

TEST_CASE("finite volumes 1D: second order against the exact series") {
  Coefficients const c = GENERATE(reading_a, reading_b);
  double const t = GENERATE(5.0, 40.0, 80.0);
  ExactSeries const exact(c);
  double coarser = 0.0;
  for (int cells : {100, 200, 400, 800}) {
    double const error = mean_absolute_error(solve_1d(Problem<>{.closure = {c}}, {t}, cells)[0], exact, t);
    if (coarser > 0.0) CHECK(std::log2(coarser / error) >= 1.9);
    coarser = error;
  }
  CHECK(coarser < 1.5e-5);
}

TEST_CASE("finite volumes 1D: bounded and conservative, at high cell Peclet numbers too") {
  int const cells = GENERATE(25, 100, 301);
  SegregationFlux const flux = GENERATE(symmetric_flux, asymmetric_flux);
  check_bounded_and_conservative(Problem<>{.flux = flux}, cells);
  check_bounded_and_conservative(Problem<>{.flux = flux, .closure = {nearly_no_diffusion}}, cells);
  check_bounded_and_conservative(Problem<ShearRateClosure>{.flux = flux}, cells);
}

TEST_CASE("finite volumes 1D: steady states") {
  Problem<> problem{.closure = {reading_b}};
  CHECK(largest_difference(solve_1d(problem, {2000.0}, 200)[0], steady_state(problem, 200)) < 2e-3);
  Profile const steady = steady_state(problem);
  for (int i = 0; i < steady.cells(); ++i)
    CHECK_THAT(steady.values[i], WithinAbs(symmetric_steady_state(reading_b.peclet(), steady.centre(i)), 1e-12));

  double coarser = 0.0;
  problem.flux = asymmetric_flux;  // approaches it slowly: F' is small where C is nearly 1
  for (int cells : {50, 100, 200}) {
    Profile const late = solve_1d(problem, {3000.0}, cells)[0];
    double const difference = largest_difference(late, steady_state(problem, cells));
    if (coarser > 0.0) CHECK(std::log2(coarser / difference) >= 1.8);
    coarser = difference;
  }
  CHECK(coarser < 2e-3);
}

TEST_CASE("shear-rate closure: (5.5), its clock and its steady state") {
  ShearRateClosure const closure{.mean = reading_b, .reference_diameter = 6.0};
  CHECK_THAT(closure.velocity(0.5), WithinAbs(reading_b.velocity, 1e-15));
  CHECK_THAT(closure.velocity(0.0), WithinAbs(reading_b.velocity * 8.0 / 6.0, 1e-15));
  CHECK_THAT(closure.diffusivity(1.0), WithinAbs(reading_b.diffusivity * 4.0 / 9.0, 1e-15));
  for (double t : {0.1, 0.26, 0.49, 0.6, 0.77, 3.9}) {
    CHECK_THAT((closure.clock(t + 1e-6) - closure.clock(t - 1e-6)) / 2e-6, WithinAbs(closure.rate(t), 1e-8));
    CHECK_THAT(closure.time(closure.clock(t)), WithinAbs(t, 1e-12));
  }
  for (double t : {0.0, 0.25, 0.5, 0.75, 17.0}) CHECK_THAT(closure.clock(t), WithinAbs(t, 1e-14));

  Problem<ShearRateClosure> const problem{.closure = closure};
  CHECK(largest_difference(solve_1d(problem, {1000.0}, 200)[0], steady_state(problem, 200)) < 2e-3);
}

}  // namespace scree::test::finite_volume_1d_tests
