// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/granular.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/openings/inlet.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <string>
#include <vector>

namespace scree::test::beside_walls_tests {
namespace {

template <int Dim>
struct Rain : Formulation<Dim> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Granular<>;
  using integrator = SymplecticEuler;
};
struct Way {
  double speed = 0.19;       ///< of that of sound
  int off = 0;               ///< spacings from the layer to the walls
  double share = 1;          ///< of the rate of full layers
  bool smooth = false;       ///< walls
  bool start_checks = true;  ///< of the settings
  double mach = 1;           ///< largest_mach
};

/// What a run says of grains that rain into a box through all of its section.
template <int Dim = 3>
std::string said(Way const& way) {
  using X = Vec<Dim, double>;
  double const dr = 3e-3, half = 8 * dr, wide = half - way.off * dr;
  X low = X::Constant(-half), high = X::Constant(half), first = X::Constant(-wide), last = X::Constant(wide);
  low[Dim - 1] = 0, high[Dim - 1] = 30 * dr, first[Dim - 1] = 20 * dr, last[Dim - 1] = 21 * dr;
  std::string text;
  SolverSettings<Rain<Dim>> settings{.spacing = dr, .warn = [&](std::string const& warning) { text += warning; }};
  settings.physics.law = {.elastic = {.young = 3e5, .poisson = 0.3, .rest_density = 1500},
                          .grains = {.diameter = 1e-3}};
  settings.start_checks = way.start_checks, settings.physics.largest_mach = way.mach;
  Solver<Rain<Dim>> solver(settings, std::vector<X>{}, wall_around(Box<Dim>{low, high}, dr, 3));
  if (way.smooth) solver.template set<Wall>(fields::slip_normal, [](auto const&) { return X(X::UnitX()); });
  Inlet<Dim> inlet{.layer = fill_lattice(Box<Dim>{first, last}, dr), .pushes = false};
  inlet.velocity[Dim - 1] = -way.speed * settings.physics.law.sound_speed();
  inlet.rate = way.share * double(inlet.layer.size()) * std::pow(dr, Dim - 1) * inlet.velocity.norm();
  solver.feed(inlet);
  return text;
}

}  // namespace

TEST_CASE("full layers that rain fast between rough walls in space give a warning, and only they do") {
  CHECK_THAT(said({}),
             Catch::Matchers::ContainsSubstring("warning: inlet 'inlet' rains full layers beside rough walls"));
  CHECK(said({.share = 0.95}) != "");
  CHECK(said({.speed = 0.11}) != "");
  CHECK(said({.speed = 0.09}) == "");
  CHECK(said({.speed = 0.11, .mach = 10}) != "");
  CHECK(said({.off = 1}) == "");
  CHECK(said({.share = 0.5}) == "");
  CHECK(said({.smooth = true}) == "");
  CHECK(said({.start_checks = false}) == "");
  CHECK(said<2>({}) == "");
}

}  // namespace scree::test::beside_walls_tests
