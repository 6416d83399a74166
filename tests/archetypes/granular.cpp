// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "advection.hpp"
#include "density.hpp"
#include "force.hpp"
#include "grains.hpp"
#include "law.hpp"
#include "section.hpp"
#include "strain.hpp"
#include "stress_filter.hpp"
#include "transport.hpp"
#include "volume_control.hpp"
#include "walls.hpp"

#include <scree/granular/granular.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

namespace scree::test::granular_tests {
using namespace fields;
namespace {

template <class OfLaw>
struct Models : GranularModels {
  using law = OfLaw;
  using filter = archetypes::Filter;
  using volume_control = archetypes::Control;
  using walls = archetypes::Walls;
  using strain = archetypes::Strain;
  using forces = std::tuple<archetypes::Force>;
  using advection = archetypes::WithTheFlow;
};
template <class Physics, class OfIntegrator>
struct Case : Formulation<2> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Physics;
  using integrator = OfIntegrator;
};

/// A block without gravity, at rest and without stress.
template <class Physics, class OfIntegrator>
Solver<Case<Physics, OfIntegrator>> block(Physics const& physics) {
  return Solver<Case<Physics, OfIntegrator>>({.spacing = 0.1, .physics = physics},
                                             fill_lattice(Box<2>{{0, 0}, {1, 0.5}}, 0.1));
}

}  // namespace

TEMPLATE_TEST_CASE("a granular material of the least models falls under their force", "", Midpoint, SymplecticEuler) {
  using Mechanics = Granular<Models<archetypes::Law>>;
  auto solver = block<Combined<Mechanics, archetypes::Transport>, TestType>(
      {.mechanics = {.law = {1500, 1e4}, .gravity = {0}}, .transport = {}});
  solver.set(concentration, [](auto const&) { return 0.5; });
  solver.run(0.1);
  for (auto const& u : solver.material().to_host(velocity)) {
    CHECK(std::abs(u[0] - 0.1) < 1e-12);
    CHECK(std::abs(u[1]) < 1e-12);
  }
}

TEST_CASE("a law has the strength of the least section in the direction of its deviator") {
  MuOfI<> const law{.elastic = {1e5, 0.3, 1500}, .grains = {1e-3}};
  Record<detail::AnyPoint, Fields<ShearRate>> const point{};
  using InSection = PointOfSection<std::remove_cv_t<decltype(point)>, archetypes::Section>;
  for (double const way : {1.0, -1.0}) {
    StressTensor<double> const trial = -100 * identity_matrix<StressTensor<double>>() +
                                       way * StressTensor<double>(Vec<3, double>(200, 200, -400).asDiagonal());
    auto const borne = law.admissible(trial, InSection{point}, NoHistory{});
    double const expected = law.shear_strength(100.0, point) * (1 + way / 10);
    CHECK(std::abs(equivalent_shear_stress(deviator_of(borne)) / expected - 1) < 1e-12);
  }
}

TEST_CASE("the least grains have the friction of uniform grains of their size") {
  MuOfI<archetypes::OneMillimetre> const least{.elastic = {1e5, 0.3, 1500}};
  MuOfI<> const uniform{.elastic = {1e5, 0.3, 1500}, .grains = {1e-3}};
  auto solver = block<Granular<Models<MuOfI<archetypes::OneMillimetre>>>, Midpoint>({.law = least});
  solver.run(0.01);
  Record<detail::AnyPoint, Fields<ShearRate>> point{};
  CHECK(least.shear_strength(100.0, point) == uniform.shear_strength(100.0, point));
}

}  // namespace scree::test::granular_tests
