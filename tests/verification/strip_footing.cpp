// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "soil.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <numbers>

// A rigid strip on weightless clay without friction. In plane strain this cone is Tresca's: the shear strength is c.
// The strip breaks in at (2 + pi) c (Prandtl 1920), whatever the stiffness.
namespace scree::test::soil::strip_footing_tests {
namespace {

double const width = 1, cohesion = 1000;  // m, Pa
X const of_clay{2, 1.1};                  // m; the mechanism reaches 1.5 m from the centre and 0.71 m deep

/// The right half of soil of a size, with a smooth wall in the plane of symmetry; `across` spacings below half the
/// strip.
Case half(double across, X const& size = of_clay, double friction_angle = 0) {
  double const wide = size[0], deep = size[1], dr = width / 2 / across, t = rows * dr;
  Case now{.spacing = dr, .soil = {{0, 0}, {wide, deep}}, .gravity = 0};
  now.walls.add("moving", fill_lattice(Box<2>{{0, deep}, {width / 2, deep + t}}, dr));
  now.walls.add("floor", fill_lattice(Box<2>{{-t, -t}, {wide + t, 0}}, dr));
  now.walls.add("symmetry", fill_lattice(Box<2>{{-t, 0}, {0, deep + 2 * t}}, dr));
  now.walls.add("side", fill_lattice(Box<2>{{wide, 0}, {wide + t, deep}}, dr));
  now.law = {.elastic = {.young = 2000 * cohesion, .poisson = 0.3, .rest_density = 2000},
             .cone = plane_strain_cone({.friction_angle = friction_angle, .cohesion = cohesion})};
  now.push = {.direction = X(0, -1), .speed = 0.02, .rise = 0.3};
  return now;
}
/// The mean pressure below the strip over the cohesion, when it has sunk by 4 to 5 % of its width.
double bearing_factor(Case const& footing) {
  auto solver = footing.solver<SymplecticEuler>();
  set_slip(solver, footing.walls, "symmetry", X(1, 0));
  set_slip(solver, footing.walls, "side", X(-1, 0));
  double const force = resistance(footing, solver, 0.05 * width);
  show_packing(solver);
  return force / (width / 2 * cohesion);
}

}  // namespace

TEST_CASE("a strip breaks into clay at the pressure of Prandtl", "[verification]") {
  double const coarse = bearing_factor(half(10)), fine = bearing_factor(half(20));
  double const exact = 2 + std::numbers::pi, extrapolated = 2 * fine - coarse;
  CAPTURE(coarse, fine, extrapolated, exact);
  CHECK(std::abs(extrapolated / exact - 1) < 0.05);
  CHECK(std::abs(fine / exact - 1) < 0.05);
}

TEST_CASE("control: a clay with friction carries more than Prandtl's pressure", "[verification]") {
  double const factor = bearing_factor(half(10, {2.5, 1.5}, degrees(10)));  // 8.3 for an associated flow
  CAPTURE(factor);
  CHECK(factor > 1.2 * (2 + std::numbers::pi));
}

}  // namespace scree::test::soil::strip_footing_tests
