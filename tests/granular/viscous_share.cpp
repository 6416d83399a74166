// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/granular.hpp>
#include <scree/granular/viscous_share.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <string>

namespace scree::test::viscous_share_tests {
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

/// Returns the warnings of a run of a column of `rows` rows, until its fall is over, with a viscosity (m/s).
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

TEMPLATE_TEST_CASE("the share that a viscosity rules in simple shear follows from its stress", "", In<2>, In<3>) {
  constexpr int dim = TestType::dim;
  double const dr = 0.1, rate = 2, size = 1.6;
  using X = Vec<dim, double>;
  Solver<Sand<dim>> solver({.spacing = dr}, fill_lattice(Box<dim>{X::Zero(), X::Constant(size)}, dr));
  int const last = dim - 1;
  double const nu = effective_viscosity(0.5, 1.5 * dr, dim), viscous = 1500 * nu * rate;  // Pa
  solver.set(velocity, [&](X const& x) { return X(rate * (x[last] - size / 2) * X::Unit(0)); });
  solver.update_rates();
  // One half of the material, and of its momentum, has more than the viscous stress, the other one a fifth.
  solver.set(stress, [&](X const& x) {
    Mat<3, double> sigma = -100 * Mat<3, double>::Identity();
    sigma(0, last) = sigma(last, 0) = (x[0] < size / 2 ? 1.2 : 0.2) * viscous;
    return packed<dim>(sigma);
  });
  auto const share = [&](double gravity) { return viscous_share(solver.whole(), 0.5, 1500, gravity); };
  CHECK(share(0) == 0);
  // The power is nu rate^2 at speeds up to rate size/2.
  double const weak = nu * rate / size;
  CHECK(std::abs(share(weak) - 0.5) < 0.06);
  CHECK(share(1e3 * weak) < 0.05);
}

TEST_CASE("a viscosity that rules more than half of a flow is warned of") {
  CHECK_THAT(warning_of_viscosity(0.8, 10),
             ContainsSubstring("on 80 % of the material that moves the artificial viscosity acts more than") &&
                 ContainsSubstring("a viscosity_speed of 10 m/s") && ContainsSubstring("ResidualViscosity"));
  CHECK(warning_of_viscosity(0.45, 0.5) == "");
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

}  // namespace scree::test::viscous_share_tests
