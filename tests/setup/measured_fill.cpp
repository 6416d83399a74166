// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/measured_fill.hpp>
#include <scree/setup/mesh/mesh.hpp>
#include <scree/setup/mesh/placement.hpp>
#include <scree/setup/shapes/polygon.hpp>

#include "mesh/bodies.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <numbers>

// Volumes of shapes, and fillings that keep them.
namespace scree::test::measured_fill_tests {
namespace {

using Catch::Matchers::ContainsSubstring;

template <class Fill>
double total(Fill const& fill) {
  double sum = 0;
  for (double const v : fill.volumes) sum += v;
  return sum;
}
/// A shape without any knowledge of its volume.
template <Shape S>
auto unknown(S const& shape) {
  return shape | shape;
}

}  // namespace

TEST_CASE("the volume below a level is exact for simple shapes") {
  using std::numbers::pi;
  double const infinity = std::numeric_limits<double>::infinity();
  auto const below = [](auto const& shape, double level) { return VolumeBelow(shape, 0.1)(level); };
  CHECK(std::abs(below(Box<3>{{0, 1, 2}, {1, 3, 5}}, infinity) - 6) < 1e-15);
  CHECK(std::abs(below(Box<3>{{0, 1, 2}, {1, 3, 5}}, 3) - 2) < 1e-15);
  CHECK(below(Box<2>{{0, 1}, {1, 3}}, 0.5) == 0);
  CHECK(std::abs(below(Ball<3>{{0, 0, 1}, 2}, infinity) - 32 * pi / 3) < 1e-13);
  CHECK(std::abs(below(Ball<3>{{0, 0, 1}, 2}, 1) - 16 * pi / 3) < 1e-13);
  CHECK(std::abs(below(Ball<2>{{0, 1}, 2}, 1) - 2 * pi) < 1e-13);
  CHECK(std::abs(below(Ball<2>{{0, 1}, 2}, 2) - (4 * (2 * pi / 3) + std::sqrt(3.0))) < 1e-13);
  CHECK(std::abs(below(Cylinder{2, {0, 0, 0}, 1, -1, 2}, 1) - 2 * pi) < 1e-13);
  CHECK(std::abs(below(Cylinder{1, {0, 0, 3}, 1, -1, 2}, 3) - 1.5 * pi) < 1e-13);
}

TEST_CASE("the volume of a mesh below a level is that of the body of triangles") {
  Mesh const block(
      placed(box_mesh({0, 0, 0}, {1, 2, 3}), {.rotation = rotation_about({1, 0, 0}, std::numbers::pi / 4)}));
  // A section across the first axis is a rectangle of 2 x 3 on its corner.
  VolumeBelow const below(block, 0.1);
  double const z = block.bounds().low[2];
  CHECK(std::abs(z) < 1e-15);
  for (double const depth : {0.3, 1.0, std::sqrt(2.0)}) CHECK(std::abs(below(z + depth) - depth * depth) < 1e-14);
  CHECK(std::abs(below.total() - 6) < 1e-13);
  CHECK(std::abs(below(below.level_of(1.234)) - 1.234) < 1e-13);
}

TEST_CASE("the volume of other shapes is of second order in the spacing") {
  Ball<3> const ball{{0.01, 0.02, 0.03}, 0.5};
  double const exact = std::numbers::pi / 6;
  for (double const dr : {0.1, 0.05, 0.025}) {
    CAPTURE(dr);
    CHECK(std::abs(volume_of(unknown(ball), dr) / exact - 1) < 0.4 * dr * dr);
    CHECK(std::abs(VolumeBelow(unknown(ball), dr)(0.03) / (exact / 2) - 1) < 0.4 * dr);
  }
  Box<2> const box{{0.013, 0.2}, {1.07, 0.9}};
  CHECK(std::abs(volume_of(unknown(box), 0.04) / (1.057 * 0.7) - 1) < 1e-3);
  Mesh const holed(with_holes(sphere_mesh(0.5, 40), 0.02));
  CHECK(std::abs(volume_of(holed, 0.05) / exact - 1) < 0.01);
  CHECK(std::abs(volume_of(unknown(Mesh(sphere_mesh(0.5, 40))), 0.05) / exact - 1) < 5e-3);
}

TEST_CASE("a filling represents the volume of its shape to 1e-12") {
  using std::numbers::pi;
  double const dr = 0.05;
  Mesh const mesh(torus_mesh(1, 0.4, 40, 16));
  auto const all = fill_measured(mesh, dr);
  CHECK(all.points == fill_lattice(mesh, dr));
  CHECK(std::abs(total(all) / mesh.report().volume - 1) < 1e-12);
  CHECK(std::abs(all.volumes[0] / math::power<3>(dr) - 1) < 0.05);
  auto const part = fill_up_to(mesh, 0.1, dr);
  CHECK(std::abs(total(part) / *mesh.exact_volume_below(0.1) - 1) < 1e-12);
  for (auto const& x : part.points) CHECK(x[2] < 0.1);
  Ball<2> const disc{{0, 0}, 1};
  CHECK(std::abs(total(fill_measured(disc, 0.07)) / pi - 1) < 1e-12);
  auto const cut = disc - Box<2>{{0, 0}, {2, 2}};
  CHECK(std::abs(total(fill_measured(cut, 0.07)) / volume_of(cut, 0.07) - 1) < 1e-12);
  CHECK(std::abs(total(fill_measured(cut, 0.07)) / (0.75 * pi) - 1) < 3e-3);
}

TEST_CASE("a filling has the mass that is asked for, up to its level") {
  double const dr = 0.05, mass = 2000, density = 1600;
  Mesh const mesh(torus_mesh(1, 0.4, 40, 16));
  auto const bed = fill_with_mass(mesh, mass, density, dr);
  CHECK(std::abs(total(bed) * density / mass - 1) < 1e-12);
  CHECK(std::abs(*mesh.exact_volume_below(bed.level) * density / mass - 1) < 1e-12);
  for (auto const& x : bed.points) CHECK(x[2] < bed.level);
  Polygon const basin(Polygon::Loop{{0, 0}, {2, 0}, {3, 2}, {-1, 2}});
  auto const flat = fill_with_mass(basin, 5, 2, dr);  // h (2 + h/2) = 2.5
  CHECK(std::abs(flat.level - (std::sqrt(4 + 5.0) - 2)) < 1e-12);
  CHECK(std::abs(total(flat) - 2.5) < 1e-11);
  CHECK_THROWS_WITH(fill_with_mass(mesh, 1e6, density, dr),
                    ContainsSubstring("need a volume of 625 m^3, and the shape has 3.0"));
  CHECK_THROWS_WITH(fill_with_mass(mesh, -1, density, dr),
                    ContainsSubstring("mass of a filling (kg) must be above 0, not -1"));
  CHECK_THROWS_WITH(fill_measured(Box<3>{{0, 0, 0}, {1, 1, 0.03}}, dr), ContainsSubstring("too thin for this spacing"));
  CHECK_THROWS_WITH(fill_up_to(mesh, -5, dr), ContainsSubstring("too small"));
  CHECK_THROWS_WITH(fill_up_to(mesh, std::nan(""), dr), ContainsSubstring("the level (m) of a filling"));
}

}  // namespace scree::test::measured_fill_tests
