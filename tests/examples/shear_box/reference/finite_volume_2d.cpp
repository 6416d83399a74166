// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception

#include "../../../../examples/shear_box/reference/finite_volume_2d.hpp"
#include "../../../../examples/shear_box/reference/exact.hpp"
#include "../../../../examples/shear_box/reference/finite_volume_1d.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scree::test::finite_volume_2d_tests {
using namespace shear_box::reference;
using Catch::Matchers::WithinAbs;

namespace {

double mean_absolute_difference(Field2d const& coarse, Field2d const& fine) {
  double difference = 0.0;
  for (int j = 0; j < coarse.rows; ++j)
    for (int i = 0; i < coarse.columns; ++i)
      difference += std::abs(coarse.value(i, j) - fine(coarse.centre(i), coarse.centre(j)));
  return difference / static_cast<double>(coarse.values.size());
}

template <class F>
double largest_difference(Field2d const& field, const F& of_height) {
  double difference = 0.0;
  for (int j = 0; j < field.rows; ++j)
    for (int i = 0; i < field.columns; ++i)
      difference = std::max(difference, std::abs(field.value(i, j) - of_height(j)));
  return difference;
}

template <class Closure>
void check_bounded_and_conservative(Problem<Closure> const& problem, double spacing) {
  for (Field2d const& field : solve_2d(problem, {0.01, 1.0, 10.0, 30.3, 80.0}, spacing)) {
    CHECK(*std::min_element(field.values.begin(), field.values.end()) >= 0.0);
    CHECK(*std::max_element(field.values.begin(), field.values.end()) <= 1.0);
    CHECK_THAT(field.mean(), WithinAbs(0.5, 1e-13));
  }
}

template <class Closure>
void check_second_order(Problem<Closure> const& problem) {
  auto const solved = [&](double spacing) { return solve_2d(problem, {10.0}, spacing)[0]; };
  Field2d const solutions[] = {solved(0.02), solved(0.01), solved(0.005)};
  Field2d const fine = extrapolate(solved(0.0025), solutions[2]);
  double coarser = 0.0;
  for (Field2d const& solution : solutions) {
    double const error = mean_absolute_difference(solution, fine);
    INFO("spacing " << solution.h << ", mean absolute error " << error << " after " << coarser);
    if (coarser > 0.0) CHECK(std::log2(coarser / error) >= 1.9);
    coarser = error;
  }
  CHECK(coarser < 5e-4);
}

constexpr Coefficients nearly_no_diffusion{.velocity = 0.03, .diffusivity = 1e-6};

}  // namespace

TEST_CASE("finite volumes 2D: without shear equal to one dimension") {
  Problem<> const problem{.flux = asymmetric_flux, .shear_amplitude = 0.0};
  Profile const profile = solve_1d(problem, {20.0}, 100)[0];
  Field2d const field = solve_2d(problem, {20.0}, 0.01)[0];
  CHECK(largest_difference(field, [&](int j) { return profile.values[j]; }) < 1e-5);  // other time steps

  // V and D that follow the shear rate in time, and an output time at which clock and time differ.
  Problem<ShearRateClosure> const varying{.shear_amplitude = 0.0};
  Profile const varying_profile = solve_1d(varying, {10.1}, 100)[0];
  Field2d const varying_field = solve_2d(varying, {10.1}, 0.01)[0];
  CHECK(largest_difference(varying_field, [&](int j) { return varying_profile.values[j]; }) < 1e-5);
}

TEST_CASE("finite volumes 2D: second order in the oscillating box") {
  SECTION("symmetric flux") { check_second_order(Problem<>{}); }
  SECTION("asymmetric flux") { check_second_order(Problem<>{.flux = asymmetric_flux}); }
  SECTION("shear-rate closure") { check_second_order(Problem<ShearRateClosure>{}); }
}

TEST_CASE("finite volumes 2D: second order for a field that varies along all four walls") {
  // Near bottom and top of the real box C hardly depends on X, which would hide a wrong flux along them.
  auto const solve = [](double spacing) {
    Problem<> const problem{.closure = {{.velocity = 0.02, .diffusivity = 0.02}}};
    using Box = shear_box::reference::detail::ShearedBox<ConstantClosure>;
    Box box(problem, spacing);
    Field2d field{.h = spacing, .columns = box.columns(), .rows = box.rows(), .values = {}};
    for (int j = 0; j < field.rows; ++j)
      for (int i = 0; i < field.columns; ++i)
        field.values.push_back(0.5 + 0.3 * std::cos(std::numbers::pi * field.centre(i) / field.width()) +
                               0.1 * std::sin(5.0 * field.centre(j)));
    SspRungeKutta<Box> integrator(box, {.euler_limit = box.euler_limit(), .longest = 0.01}, field.values.size());
    integrator.advance(field.values, 0.0, 0.4);
    return field;
  };
  Field2d const fine = extrapolate(solve(0.0025), solve(0.005));
  double const coarse = mean_absolute_difference(solve(0.02), fine);
  double const middle = mean_absolute_difference(solve(0.01), fine);
  INFO("mean absolute error " << coarse << " (spacing 0.02), " << middle << " (0.01)");
  CHECK(std::log2(coarse / middle) >= 1.9);
  CHECK(std::log2(middle / mean_absolute_difference(solve(0.005), fine)) >= 1.9);
}

TEST_CASE("finite volumes 2D: extrapolated, and how far from one dimension") {
  Field2d const coarse = solve_2d_extrapolated(Problem<>{}, {80.0}, 0.01)[0];
  Field2d const field = solve_2d_extrapolated(Problem<>{}, {80.0}, 0.005)[0];
  CHECK(mean_absolute_difference(coarse, field) < 1e-4);

  ExactSeries const exact(reading_a);
  Profile const mean = field.width_mean();
  Profile const centre = field.centre_column();
  double mean_difference = 0.0, centre_difference = 0.0;
  for (int j = 0; j < field.rows; ++j) {
    mean_difference += std::abs(mean.values[j] - exact(field.centre(j), 80.0)) / field.rows;
    centre_difference += std::abs(centre.values[j] - exact(field.centre(j), 80.0)) / field.rows;
  }
  CHECK_THAT(mean_difference, WithinAbs(2.75e-3, 2e-5));
  CHECK_THAT(centre_difference, WithinAbs(2.16e-3, 2e-5));
}

TEST_CASE("finite volumes 2D: conservative and in [0, 1], from the first step on and at high cell Peclet numbers") {
  double const spacing = GENERATE(0.04, 0.02, 0.01);
  SegregationFlux const flux = GENERATE(symmetric_flux, asymmetric_flux);
  check_bounded_and_conservative(Problem<>{.flux = flux, .closure = {reading_b}}, spacing);
  check_bounded_and_conservative(Problem<>{.flux = flux, .closure = {nearly_no_diffusion}}, spacing);
  check_bounded_and_conservative(Problem<ShearRateClosure>{.flux = flux}, spacing);
  check_bounded_and_conservative(Problem<>{.flux = flux, .shear_amplitude = 0.9}, spacing);
}

TEST_CASE("finite volumes 2D: steady state does not know the shear") {
  Problem<> const problem{.closure = {reading_b}};
  Field2d const field = solve_2d(problem, {1000.0}, 0.02)[0];
  Profile const profile = solve_1d(problem, {1000.0}, 50)[0];  // of the same discrete equations
  CHECK(largest_difference(field, [&](int j) { return profile.values[j]; }) < 1e-10);
  CHECK(largest_difference(solve_2d(problem, {1000.0}, 0.01)[0],
                           [&](int j) { return symmetric_steady_state(reading_b.peclet(), 0.01 * (j + 0.5)); }) < 5e-3);
}

TEST_CASE("field: samples cubic polynomials exactly, in the half cells next to walls too") {
  Field2d field{.h = 0.05, .columns = 8, .rows = 20, .values = {}};
  auto const C = [](double X, double Z) { return 0.3 + X - 2.0 * X * X * X + Z * Z * (1.0 - Z) + 3.0 * X * X * Z; };
  for (int j = 0; j < field.rows; ++j)
    for (int i = 0; i < field.columns; ++i) field.values.push_back(C(field.centre(i), field.centre(j)));
  for (double X : {0.0, 0.01, 0.2, 0.333, 0.4})
    for (double Z : {0.0, 0.02, 0.4, 0.77, 1.0}) CHECK_THAT(field(X, Z), WithinAbs(C(X, Z), 1e-13));
  CHECK_THAT(field.centre_column()(0.3), WithinAbs(C(0.2, 0.3), 1e-13));
}

TEST_CASE("reference solvers reject what they cannot do") {
  CHECK_THROWS(solve_2d(Problem<>{}, {1.0}, 0.03));
  CHECK_THROWS(solve_2d(Problem<>{.shear_amplitude = 1.0}, {1.0}, 0.02));
  CHECK_THROWS(solve_2d(Problem<>{}, {2.0, 1.0}, 0.02));
  CHECK_THROWS(solve_1d(Problem<>{}, {-1.0}, 100));
}

}  // namespace scree::test::finite_volume_2d_tests
