// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/granular.hpp>
#include <scree/granular/viscous_power.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace scree::test::viscous_power_tests {
namespace {

using namespace fields;
using Catch::Matchers::ContainsSubstring;

template <int Dim, class OfViscosity = PlainViscosity>
struct Sand : Formulation<Dim> {
  struct Models : GranularModels {
    using viscosity = OfViscosity;
  };
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Granular<Models>;
  using integrator = SymplecticEuler;
};
template <int Dim>
struct In {
  static constexpr int dim = Dim;
};
double const height = 0.1;  // m

/// What a run of a column of `rows` rows says until its fall is over, with a viscosity (m/s).
template <int Dim, class OfViscosity = PlainViscosity>
std::string said(double speed, int rows = 16) {
  double const dr = height / rows, c = 15;
  std::string all;
  using F = Sand<Dim, OfViscosity>;
  SolverSettings<F> settings{.spacing = dr, .warn = [&](std::string const& text) { all += text; }};
  settings.physics.law = {
      .elastic = {.young = 1500 * c * c, .rest_density = 1500}, .grains = {.diameter = 1e-3}, .mu_s = 0.42};
  settings.physics.viscosity_speed = speed;
  Vec<Dim, double> low = Vec<Dim, double>::Zero(), high = Vec<Dim, double>::Constant(4 * dr);
  Vec<Dim, double> wide = low, far = high;
  high[0] = high[Dim - 1] = height, wide[0] = -2 * height, far[0] = 3 * height, wide[Dim - 1] = -3 * dr,
  far[Dim - 1] = 0;
  if (Dim == 3) settings.periods = {{1, 0, 8 * dr}}, high[1] = far[1] = 8 * dr;
  Solver<F> solver(settings, fill_lattice(Box<Dim>{low, high}, dr), fill_lattice(Box<Dim>{wide, far}, dr));
  solver.run(3 * std::sqrt(height / 9.81));
  return all;
}

}  // namespace

TEMPLATE_TEST_CASE("the power of a viscosity and of the stress in simple shear is known", "", In<2>, In<3>) {
  constexpr int dim = TestType::dim;
  double const dr = 0.1, rate = 2, size = 0.8;
  using X = Vec<dim, double>;
  Solver<Sand<dim>> solver({.spacing = dr}, fill_lattice(Box<dim>{X::Zero(), X::Constant(size)}, dr));
  solver.set(velocity, [&](X const& x) { return X(rate * x[dim - 1] * X::Unit(0)); });
  solver.set(stress, [](X const&) {
    Mat<3, double> sigma = -100 * Mat<3, double>::Identity();
    sigma(0, dim == 2 ? 1 : 2) = sigma(dim == 2 ? 1 : 2, 0) = 30;
    return packed<dim>(sigma);
  });
  solver.update_rates();
  auto const rates = solver.material().to_host(shear_rate);
  double sum = 0, squares = 0;  // at the surface the plain gradient is smaller than in the middle
  for (double const each : rates) sum += each, squares += each * each;
  CHECK(*std::max_element(rates.begin(), rates.end()) > 0.9 * rate);
  auto const found = viscous_power(solver.whole(), 0.5, 1500, 9.81);
  double const each = std::pow(dr, dim), volume = std::pow(size, dim), nu = effective_viscosity(0.5, 1.5 * dr, dim);
  CAPTURE(found.of_viscosity, found.of_stress, found.of_weight);
  CHECK(std::abs(found.of_viscosity / (1500 * nu * squares * each) - 1) < 1e-9);
  CHECK(std::abs(found.of_stress / (30 * sum * each) - 1) < 1e-9);
  CHECK(std::abs(found.of_weight / (1500 * 9.81 * rate * size / 2 * volume) - 1) < 1e-9);
}

TEST_CASE("a viscosity that is thicker than the flow is warned of") {
  CHECK_THAT(warning_of_viscosity({2, 1, 5}, 10), ContainsSubstring("takes 2 times as much energy") &&
                                                      ContainsSubstring("a viscosity_speed of 10 m/s") &&
                                                      ContainsSubstring("ResidualViscosity"));
  CHECK(warning_of_viscosity({1.1, 1, 5}, 0.5) == "");
  CHECK(warning_of_viscosity({2, 1, 20}, 0.5) == "");  // a few grains of a bed at rest
  CHECK(warning_of_viscosity({2, 1, 0}, 0.5) == "");   // no gravity
}

TEMPLATE_TEST_CASE("a column with ten times the usual viscosity warns, and one with the usual one does not", "", In<2>,
                   In<3>) {
  constexpr int dim = TestType::dim;
  CHECK_THAT(said<dim>(10), ContainsSubstring("a viscosity_speed of 10 m/s") && ContainsSubstring("after step"));
  CHECK(said<dim>(0.5) == "");
}

TEST_CASE("a viscosity that acts on disorder alone does not warn, whatever it is") {
  CHECK(said<2, ResidualViscosity>(10) == "");
}

}  // namespace scree::test::viscous_power_tests
