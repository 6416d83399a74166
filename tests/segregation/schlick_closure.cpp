// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/segregation/conservative.hpp>
#include <scree/segregation/schlick_closure.hpp>
#include <scree/segregation/size_ratio_closure.hpp>

#include <support/bodies.hpp>
#include <support/shear_box.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scree::test::schlick_closure_tests {
using namespace fields;
namespace {

SchlickClosure const closure{.d_small = 0.1, .d_large = 0.2};

/// The equilibrium at a height, with C = 1/2 at 0.4: the root of a function that rises with C.
double equilibrium(double z) {
  double const dl = closure.d_large, ds = closure.d_small;
  auto const of = [&](double C) { return sq(dl) * std::log(C) - sq(ds) * std::log(1 - C) - sq(dl - ds) * C; };
  double const value = of(0.5) - closure.S / closure.A * ds * std::log(dl / ds) * (z - 0.4);
  double low = 0, high = 1;
  for (int k = 0; k < 200; ++k) (of((low + high) / 2) < value ? low : high) = (low + high) / 2;
  return (low + high) / 2;
}

/// The root of the mean square of dC/dt over that of its part by segregation, in a bed of height 0.8 with the
/// equilibrium.
double imbalance(double spacing) {
  using P = Policy<2, double, Kokkos::DefaultExecutionSpace>;
  using F = Formulated<P, ConservativeSegregation<SchlickClosure>, OscillatingShear>;
  OscillatingShear const swing{.amplitude = 0.5, .period = 4};
  auto const rates = [&](SchlickClosure const& with) {
    auto solver = solver_of<F>(open_bed<2>({0.8, 0.8}, spacing), spacing, {with, {}}, swing);
    set_field(solver, concentration, [](auto const& x) { return equilibrium(x[1]); });
    solver.update_rates();
    double squares = 0;
    for (double const rate : solver.material().to_host(concentration_rate)) squares += sq(rate);
    return std::sqrt(squares);
  };
  auto alone = closure;
  alone.A = 0;
  return rates(closure) / rates(alone);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("V and D of Schlick follow the shear rate, and are those of two species by their ratio", "",
                        Policies) {
  using P = TestType;
  STATIC_CHECK(SegregationClosure<SchlickClosure, P>);
  auto body = body_of<P, Concentration, ShearRate, SegregationVelocity, Diffusivity, Concentrations<2>,
                      SegregationVelocities<2>>(lattice<P::dim>(0.25), 1);
  set(body, concentration, [](auto const& x) { return x[0]; });
  set(body, shear_rate, [](auto const& x) { return 2 + x[1]; });
  for_each_particle<P>("closure", body, closure);
  double const of_sizes = 0.26 * 0.1 * std::numbers::ln2;
  auto const d = [](auto const& x) { return 0.2 - 0.1 * x[0]; };
  CHECK(largest_error(body, segregation_velocity, 2 * of_sizes, [&](auto const& x) { return of_sizes * (2 + x[1]); }) <
        ulps<P>(8));
  CHECK(largest_error(body, diffusivity, 2 * 0.042 * 0.04,
                      [&](auto const& x) { return 0.042 * (2 + x[1]) * sq(d(x)); }) < ulps<P>(8));

  auto const V = body.to_host(segregation_velocity), D = body.to_host(diffusivity);
  using Real = typename P::real;
  set(body, concentrations<2>, [](auto const& x) { return Vec<2, Real>(Real(x[0]), Real(1 - x[0])); });
  for_each_particle<P>("closure", body, SizeRatioClosure<2>{.diameters = {0.1, 0.2}});
  auto const S = body.to_host(segregation_velocities<2>);
  auto const both = body.to_host(diffusivity);
  for (std::size_t i = 0; i < V.size(); ++i) {
    CHECK(S[i][0] == V[i]);
    CHECK(std::abs(both[i] - D[i]) <= 1e-6 * D[i]);
  }
}

TEST_CASE("the equilibrium of Schlick's closure rests, to second order in the spacing, at any shear rate") {
  double const coarse = imbalance(0.04), fine = imbalance(0.02);
  INFO(coarse << " at 0.04, " << fine << " at 0.02");
  CHECK(coarse < 0.05);
  CHECK(fine < coarse / 3);
}

}  // namespace scree::test::schlick_closure_tests
