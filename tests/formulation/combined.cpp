// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/formulation/combined.hpp>

#include <scree/granular/segregating.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/segregation/shear_rate_closure.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/setup/walls.hpp>
#include <scree/solver/solver.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <numbers>

// Heat conduction, a physics model of a user, joined to granular flow.
namespace scree::test::combined_tests {
using namespace fields;
namespace {

struct TemperatureRate : Scalar<"temperature rate", "K/s"> {};
struct Temperature : Scalar<"temperature", "K"> {
  using rate = TemperatureRate;
};
inline constexpr Temperature temperature{};

/// 2 kappa sum_j V_j (T_i - T_j)/r_ij dW/dr.
struct Conduction {
  double diffusivity;  // kappa, m^2/s
  using reads = Fields<Volume, Temperature>;
  using adds = Fields<TemperatureRate>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    sum[TemperatureRate{}] += 2 * diffusivity * j[volume] * (i[temperature] - j[temperature]) * ij.slope();
  }
};
struct Heat {
  double diffusivity = 0;  // m^2/s
  using evolves = Fields<Temperature>;
  auto passes(Resolution const&) const {
    Conduction const conduction{diffusivity};
    return std::tuple(pair_pass<Material>("conduction", over<Material>(conduction), over<Wall>(conduction)));
  }
  auto limits(Resolution const& resolution) const {
    return std::tuple(limit("conduction", 0.1 * sq(resolution.smoothing_length) / diffusivity));
  }
};

struct Unfiltered : GranularModels {
  using law = Elastic;
  using filter = NoFilter;
};
using Warm = Combined<Granular<Unfiltered>, Heat>;

template <class Physics, class Integrator>
struct Case : Formulation<2> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Physics;
  using integrator = Integrator;
};

double const spacing = 0.05, thickness = 1;
double hot(double z) { return 300 + 40 * z; }

/// A plate between two walls, periodic along them, free of stress and gravity.
template <class Physics, class Integrator = Midpoint>
Solver<Case<Physics, Integrator>> plate(Physics const& physics) {
  double const width = 10 * spacing, depth = 4 * spacing;
  auto walls = fill_lattice(Box<2>{{0, -depth}, {width, 0}}, spacing);
  auto const above = fill_lattice(Box<2>{{0, thickness}, {width, thickness + depth}}, spacing);
  walls.insert(walls.end(), above.begin(), above.end());
  Solver<Case<Physics, Integrator>> solver({.spacing = spacing, .physics = physics, .periods = {{0, 0, width}}},
                                           fill_lattice(Box<2>{{0, 0}, {width, thickness}}, spacing), walls);
  solver.set(stress, [](auto const&) { return Vec<4, double>(0, 0, 0, 0); });
  solver.set(velocity, [](auto const&) { return Vec<2, double>(0, 0); });
  return solver;
}
Granular<Unfiltered> soft() { return {.law = {1e3, 0.3, 1500}, .gravity = {.magnitude = 0}}; }

}  // namespace

TEMPLATE_TEST_CASE("heat that a plate of grains conducts between two walls becomes linear", "", Midpoint,
                   SymplecticEuler) {
  auto solver = plate<Warm, TestType>({soft(), Heat{0.2}});
  solver.set(temperature, [](auto const&) { return 300.0; });
  solver.template set<Wall>(temperature, [](auto const& x) { return hot(x[1]); });
  solver.run(5);  // the slowest part decays as exp(-kappa (pi/H)^2 t) = exp(-9.9)
  double worst = 0;
  auto const x = solver.material().to_host(position);
  auto const T = solver.material().to_host(temperature);
  for (std::size_t i = 0; i < x.size(); ++i) worst = std::max(worst, std::abs(T[i] - hot(x[i][1])) / 40);
  CHECK(worst < 1e-4);
  CHECK(worst > 1e-7);
}

TEST_CASE("a wave of temperature in a plate decays at the exact rate") {
  double const kappa = 0.2, k = std::numbers::pi / thickness, end = 0.5;
  // Antisymmetric about both surfaces, so that these keep their temperature.
  auto const wave = [&](double z) { return std::sin(k * z); };
  auto solver = plate<Warm>({soft(), Heat{kappa}});
  solver.set(temperature, [&](auto const& x) { return wave(x[1]); });
  solver.run(end, {every<Solver<Case<Warm, Midpoint>>>(1e-3, [&](auto& s) {
               s.template set<Wall>(temperature,
                                    [&](auto const& x) { return wave(x[1]) * std::exp(-kappa * k * k * s.time()); });
             })});
  double error = 0;
  auto const x = solver.material().to_host(position);
  auto const T = solver.material().to_host(temperature);
  for (std::size_t i = 0; i < x.size(); ++i)
    error = std::max(error, std::abs(T[i] - wave(x[i][1]) * std::exp(-kappa * k * k * end)));
  INFO("off by " << 100 * error << " % of the amplitude at the start");
  CHECK(error < 0.01);
  CHECK(error < 0.03 * std::exp(-kappa * k * k * end));
}

TEMPLATE_TEST_CASE("joined models give the bits of the mechanics alone", "", Midpoint, SymplecticEuler) {
  auto const waves = [](auto& solver) {
    solver.set(velocity,
               [](auto const& x) { return Vec<2, double>(0.01 * std::sin(7 * x[1]), 0.02 * std::cos(9 * x[1])); });
    solver.run(0.2);
    return solver.material().to_host(stress);
  };
  auto alone = plate<Granular<Unfiltered>, TestType>(soft());
  auto joined = plate<Warm, TestType>(combine(soft(), Heat{1e-3}, 3));
  joined.set(temperature, [](auto const& x) { return hot(x[1]); });
  joined.template set<Wall>(temperature, [](auto const& x) { return hot(x[1]); });
  CHECK((waves(alone) == waves(joined)));
  CHECK(alone.steps() > 10);
}

TEST_CASE("three models join by nesting, and the segregation finds the gravity of the mechanics") {
  using Sorting = SegregatingGranular<Granular<>, ConservativeSegregation<ShearRateClosure>>;
  using All = Combined<Sorting, Heat>;
  Sorting sorting{{.law = {.elastic = {1e5, 0.3, 1500}, .grains = {1e-3}}, .gravity = {9.81, 0.3}}};
  sorting.transport.closure = {.chi_V = 5, .chi_D = 1, .d_small = 0.01, .d_large = 0.02};
  using Otherwise = Combined<Combined<Granular<>, Heat>, ConservativeSegregation<ShearRateClosure>>;
  auto const run = [&](auto const& physics) {
    auto solver = plate(physics);
    solver.set(velocity, [](auto const& x) { return Vec<2, double>(x[1], 0); });
    solver.set(concentration, [](auto const& x) { return 0.5 + 0.3 * std::sin(5 * x[1]); });
    if constexpr (OneOf<Temperature, typename std::remove_cvref_t<decltype(solver.material())>::fields>) {
      solver.set(temperature, [](auto const& x) { return hot(x[1]); });
      solver.template set<Wall>(temperature, [](auto const& x) { return hot(x[1]); });
    }
    solver.run(0.02);
    return solver.material().to_host(concentration);
  };
  auto const expected = run(sorting);
  CHECK((run(All{sorting, {1e-3}}) == expected));
  CHECK((run(Otherwise{{sorting.mechanics, {1e-3}}, sorting.transport}) == expected));
}

}  // namespace scree::test::combined_tests
