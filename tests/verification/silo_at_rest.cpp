// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "soil.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

// A silo with rough walls, five times as high as wide, whose floor sinks a little: the walls carry most of the weight.
// Janssen (1895): with k = mu_w K, the shear stress at the wall over the mean vertical stress, the vertical stress
// tends to rho g L, L = W/(2 k), as rho g L (1 - exp(-z/L)), where z counts from the surface.
namespace scree::test::soil::silo_at_rest_tests {
namespace {

double const width = 1, height = 5, rho = 1600;  // m, kg/m^3
double const weight = rho * g * width * height;  // N/m

Case silo(double across) {
  double const dr = width / across, t = rows * dr;
  Case now{.spacing = dr, .soil = {{0, 0}, {width, height}}, .gravity = g};
  now.walls.add("moving", fill_lattice(Box<2>{{0, -t}, {width, 0}}, dr));
  now.walls.add("left", fill_lattice(Box<2>{{-t, -2 * t}, {0, height + t}}, dr));
  now.walls.add("right", fill_lattice(Box<2>{{width, -2 * t}, {width + t, height + t}}, dr));
  now.law = {.elastic = {.young = 1000 * rho * g * height, .poisson = 0.3, .rest_density = rho},
             .cone = plane_strain_cone({.friction_angle = degrees(30)})};
  now.push = {.direction = X(0, -1), .speed = 0.02, .rise = 0.3};
  return now;
}

/// Means over layers as thick as half the width, from the surface down.
struct Layers {
  std::vector<double> vertical, shear;  // stress in the layer, and at its walls, Pa
};
template <class S>
Layers layers_of(S& solver, double dr) {
  using namespace fields;
  auto const x = solver.material().to_host(position);
  auto const packed = solver.material().to_host(stress);
  std::size_t const count = 10;
  Layers layers{std::vector<double>(count), std::vector<double>(count)};
  std::vector<double> inside(count), beside(count);
  for (std::size_t i = 0; i < x.size(); ++i) {
    auto const k = std::min(count - 1, std::size_t(std::max(0.0, (height - x[i][1]) / (width / 2))));
    Mat<3, double> const sigma = unpacked(packed[i]);
    layers.vertical[k] -= sigma(1, 1), ++inside[k];
    bool const at_wall = std::min(x[i][0], width - x[i][0]) < dr;
    if (at_wall) layers.shear[k] += std::abs(sigma(0, 1)), ++beside[k];
  }
  for (std::size_t k = 0; k < count; ++k) layers.vertical[k] /= inside[k], layers.shear[k] /= beside[k];
  return layers;
}
double janssen(double z, double L) { return rho * g * L * (1 - std::exp(-z / L)); }

}  // namespace

TEST_CASE("the walls of a silo carry the grains as Janssen found", "[verification]") {
  auto const now = silo(20);
  auto solver = now.solver<SymplecticEuler>();
  Geostatic const at_rest{height, rho, g, 0.5};
  solver.set(fields::stress, [&](auto const& x) { return packed_stress<2>(at_rest, x); });
  double const against_sinking = resistance(now, solver, 0.02 * width);
  solver.update_diagnostics();
  double const on_sides =
      -wall_load(solver, now.walls, "left").force[1] - wall_load(solver, now.walls, "right").force[1];
  CAPTURE(against_sinking / weight, on_sides / weight);
  CHECK(is_packed_as_at_rest(show_packing(solver)));
  CHECK(std::abs((on_sides - against_sinking) / weight - 1) < 0.02);

  auto const layers = layers_of(solver, now.spacing);
  double shear = 0, vertical = 0;
  for (std::size_t k = 1; k < 8; ++k) shear += layers.shear[k], vertical += layers.vertical[k];
  double const L = width / (2 * shear / vertical), final = rho * g * L;
  CAPTURE(shear / vertical, layers.vertical, layers.shear);
  for (std::size_t k = 1; k < 8; ++k) {
    double const z = (double(k) + 0.5) * width / 2;
    CAPTURE(k, layers.vertical[k] / final, janssen(z, L) / final);
    CHECK(std::abs(layers.vertical[k] - janssen(z, L)) < 0.05 * final);
  }
  CHECK(final < 0.4 * rho * g * height);  // control: the pressure of a liquid
}

}  // namespace scree::test::soil::silo_at_rest_tests
