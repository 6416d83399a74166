// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception

// Variables of a user at global scope, next to `using namespace scree`. This file tests that it compiles: if the
// library had one of these names, the use of the variable would be ambiguous.
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/io/rigid_series.hpp>
#include <scree/laws/hypoplastic.hpp>
#include <scree/openings/inlet.hpp>
#include <scree/scree.hpp>
#include <scree/terms/artificial_stress.hpp>
#include <scree/version.hpp>

#include <catch2/catch_test_macros.hpp>

using namespace scree;

double const acceleration = 1, velocity = 2, position = 3, mass = 4, density = 5, volume = 6, stress = 7;
double const concentration = 8, identity = 9, group = 10, pressure = 11, opening = 12, void_ratio = 13, held = 14;
double const weight = 15, gradient = 16, laplacian = 17, diffusivity = 18, dipole = 19, yielding = 20, asymmetry = 21;
double const traction = 22, facing = 23, covered = 24, shear_rate = 25, wall_force = 26, number_density = 27;
double const fill = 28, pi = 29, root = 30, power = 31, quotient = 32, version = 33, unit = 34;
#ifndef __CUDACC__  // CUDA has functions of these names at global scope
double const min = 1, max = 2;
#endif

namespace {
struct Sand : Formulation<2> {
  using physics = Granular<>;
};

double sum_of_the_users_own() {
  return acceleration + velocity + position + mass + density + volume + stress + concentration + identity + group +
         pressure + opening + void_ratio + held + weight + gradient + laplacian + diffusivity + dipole + yielding +
         asymmetry + traction + facing + covered + shear_rate + wall_force + number_density + fill + pi + root + power +
         quotient + version + unit;
}
}  // namespace

TEST_CASE("using namespace scree leaves names of fields and short names to the user") {
  CHECK(sum_of_the_users_own() == 34 * 35 / 2);
#ifndef __CUDACC__
  CHECK(max - min == 1);
#endif

  Granular<> sand;
  sand.law = {.elastic = {1e6, 0.3, 1500}, .grains = {5e-4}};
  Solver<Sand> solver({.spacing = 0.1, .physics = sand}, fill_lattice(Box<2>{{0, 0}, {1, 0.5}}, 0.1));
  solver.set(fields::velocity, [](auto const&) { return Vec<2, double>(velocity, 0); });
  CHECK(solver.material().to_host(fields::velocity).front()[0] == velocity);
}
