// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "granular.hpp"

#include <scree/integrators/symplectic_euler.hpp>
#include <scree/laws/elastic.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/setup/setup.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <type_traits>
#include <vector>

// A closed box full of soil under pressure turns as a rigid body with its walls, and a free block of elastic soil turns
// by itself, without gravity. The pressure must not change.
namespace scree::test::turning_box_tests {
namespace {

template <class OfStrain>
struct Sand : GranularModels {
  using strain = OfStrain;
};
template <class OfStrain>
struct Soil : Sand<OfStrain> {
  using law = Elastic;
  using filter = NoFilter;
};
template <class Models>
struct Turning : Formulation<2> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Granular<Models>;
  using integrator = SymplecticEuler;
  using motion = Rotation;
};
double const rho = 1800, young = 5e6, half = 0.5, dr = 0.05, rate = 1;  // kg/m^3, Pa, m, m, rad/s

struct Turned {
  double pressure;    // mean, Pa
  double difference;  // largest of a particle from the pressure at the start, Pa
  int warnings;
  double momentum;  // angular, over that at the start
};
template <class Models>
Turned turned(double turns, double pressure, bool in_box) {
  using namespace fields;
  using X = Vec<2, double>;
  Box<2> const inside{{-half, -half}, {half, half}};
  Turned found{};
  SolverSettings<Turning<Models>> settings{.spacing = dr, .motion = Rotation{.rate = rate}};
  settings.warn = [&](std::string const& text) {
    UNSCOPED_INFO(text);
    if (text.find("turns as a rigid body") != std::string::npos) ++found.warnings;
  };
  if constexpr (std::is_same_v<typename Models::law, Elastic>)
    settings.physics.law = {young, 0.3, rho};
  else
    settings.physics.law = {.elastic = {young, 0.3, rho}, .grains = {1e-3}};
  settings.physics.gravity.magnitude = 0;
  settings.physics.cfl = 0.6;
  Solver<Turning<Models>> solver(settings, fill_lattice(inside, dr),
                                 in_box ? wall_around(inside, dr, 3) : std::vector<X>());
  solver.set(velocity, [](X const& x) { return X(-rate * x[1], rate * x[0]); });
  solver.set(stress, [&](X const&) { return Vec<4, double>(-pressure, -pressure, -pressure, 0); });
  auto const angular = [&] {
    auto const x = solver.material().to_host(position), u = solver.material().to_host(velocity);
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += x[i][0] * u[i][1] - x[i][1] * u[i][0];
    return sum;
  };
  double const before = angular();
  solver.run(2 * std::numbers::pi * turns / rate);
  found.momentum = angular() / before;
  auto const sigma = solver.material().to_host(stress);
  for (auto const& each : sigma) {
    found.pressure -= (each[0] + each[1] + each[2]) / 3 / double(sigma.size());
    found.difference = std::max({found.difference, std::abs(each[0] + pressure), std::abs(each[1] + pressure)});
  }
  show_packing(solver);
  return found;
}

}  // namespace

// The forces that keep the soil on its way change the pressure by rho rate^2 r^2/2, up to 450 Pa in the corners.
TEST_CASE("with the objective strain soil in a box keeps its pressure for a turn") {
  auto const check = [](Turned const& found) {
    CAPTURE(found.pressure, found.difference);
    CHECK(std::abs(found.pressure - 2000) < 10);
    CHECK(found.difference < 500);
    CHECK(found.warnings == 0);
  };
  check(turned<Sand<ObjectiveStrain>>(1, 2000, true));
  check(turned<Soil<ObjectiveStrain>>(1, 2000, true));
}
TEST_CASE("with the objective strain a free block turns without stress of its own") {
  auto const [pressure, difference, warnings, momentum] = turned<Soil<ObjectiveStrain>>(0.5, 0, false);
  CAPTURE(pressure, difference, momentum);
  CHECK(std::abs(momentum - 1) < 1e-10);
  CHECK(difference < 1000);  // 2e-4 of E
}
TEST_CASE("the plain strain makes stress of a rotation, and a run warns of it once") {
  auto const [pressure, difference, warnings, momentum] = turned<Sand<PlainStrain>>(0.5, 2000, true);
  CHECK(pressure > 2500);
  CHECK(warnings == 1);
  auto const free = turned<Soil<PlainStrain>>(0.125, 0, false);
  CHECK(free.difference > 1e5);
  CHECK(std::abs(free.momentum - 1) > 1e-8);
}

}  // namespace scree::test::turning_box_tests
