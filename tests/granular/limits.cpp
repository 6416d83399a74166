// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/granular.hpp>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

namespace scree::test::limits_tests {
namespace {

/// The speed of plane waves is sqrt(M/rho), M = E (1 - nu)/((1 + nu)(1 - 2 nu)).
Granular<> sand() {
  Granular<> mechanics;
  mechanics.law = {.elastic = {1e5, 0.3, 1500}, .grains = {5e-4}};
  mechanics.cfl = 0.2;
  mechanics.viscosity_speed = 0.5;
  return mechanics;
}
Resolution resolution_of(double h, int dimensions) {
  return {.dimensions = dimensions, .spacing = h / 1.5, .smoothing_length = h};
}

}  // namespace

TEST_CASE("the step of a granular material is a part of h over the speed of plane waves") {
  double const modulus = 1e5 * 0.7 / (1.3 * 0.4), c = std::sqrt(modulus / 1500);
  for (double const h : {0.15, 0.015}) {
    auto const acoustic = std::get<0>(sand().limits(resolution_of(h, 2)));
    CHECK(acoustic.name == "acoustic");
    CHECK(acoustic.step == Catch::Approx(0.2 * h / c).epsilon(1e-12));
  }
}

TEST_CASE("the step of a granular material is a part of the time to fall by h") {
  auto const force = std::get<1>(sand().limits(resolution_of(0.15, 2)));
  CHECK(force.name == "force");
  CHECK(force.step(0.15) == Catch::Approx(0.2).epsilon(1e-12));
  CHECK(force.step(15) == Catch::Approx(0.02).epsilon(1e-12));
}

TEST_CASE("the step of a granular material is an eighth of the time in which viscosity acts over h") {
  // nu = speed h/(4 (dim + 2)): docs/theory.
  double const h = 0.15, in_plane = std::get<2>(sand().limits(resolution_of(h, 2))).step,
               in_space = std::get<2>(sand().limits(resolution_of(h, 3))).step;
  CHECK(in_plane == Catch::Approx(h * h / (0.5 * h / 16) / 8).epsilon(1e-12));
  CHECK(in_space == Catch::Approx(h * h / (0.5 * h / 20) / 8).epsilon(1e-12));
}

}  // namespace scree::test::limits_tests
