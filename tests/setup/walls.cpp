// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/lattice.hpp>
#include <scree/setup/walls.hpp>

#include "distances.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::walls_tests {
namespace {

/// Whether material and wall fill the support of radius `reach` (in spacings) of every material particle, without a gap
/// and without a double particle, as an unbounded lattice does.
template <int Dim>
void check_full_support(std::vector<Vec<Dim, double>> const& material, std::vector<Vec<Dim, double>> const& wall,
                        double spacing, double reach) {
  double const distance = reach * spacing;
  Vec<Dim, double> const centre = Vec<Dim, double>::Constant(spacing / 2);
  Vec<Dim, double> const five = Vec<Dim, double>::Constant(5 * spacing);
  int const full = number_within(fill_lattice(Box<Dim>{-five, five}, spacing), centre, distance);
  auto const all = joined(material, wall);
  REQUIRE_FALSE(material.empty());
  for (auto const& x : material) CHECK(number_within(all, x, distance) == full);
}

}  // namespace

TEST_CASE("walls: three rows around a box fill every support of three spacings, of any size of the box") {
  double const spacing = 0.1;
  for (double const height : {0.8, 0.84, 0.85, 0.86, 0.8500000001}) {
    Box<2> const box{{-0.3, 0.2}, {0.7, 0.2 + height}};
    CAPTURE(height);
    auto const material = fill_lattice(box, spacing), wall = wall_around(box, spacing, 3);
    check_full_support(material, wall, spacing, 3.01);
    CHECK(std::abs(least_distance(joined(material, wall)) - spacing) < 1e-12);
    for (auto const& x : wall) CHECK(box.signed_distance(x) < 0.3 + 1e-9);
  }
  Box<3> const block{{0, 0, 0}, {0.4, 0.3, 0.2}};
  check_full_support(fill_lattice(block, spacing), wall_around(block, spacing, 3), spacing, 3.01);
  // Two rows are too few.
  Box<2> const box{{0, 0}, {1, 1}};
  auto const material = fill_lattice(box, spacing), thin = wall_around(box, spacing, 2);
  CHECK(number_within(joined(material, thin), material[0], 3.01 * spacing) < 29);
}

TEST_CASE("walls: around a box they are those between two boxes but for their rounded edges") {
  Box<2> const inner{{0, 0}, {1, 0.5}};
  auto const wall = wall_around(inner, 0.1, 3);
  auto const square = fill_between(inner, Box<2>{{-0.3, -0.3}, {1.3, 0.8}}, 0.1);
  CHECK(wall.size() == square.size() - 4);  // of 3 x 3 in a corner, only that at 2.5 sqrt(2) = 3.5 is too far
  for (auto const& x : wall) CHECK(number_within(square, x, 1e-12) == 1);
}

TEST_CASE("walls: around round and cut shapes they fill every support, too") {
  double const spacing = 0.05;
  Ball<2> const disc{.centre = {0.1, 0.2}, .radius = 0.53};
  check_full_support(fill_lattice(disc, spacing), wall_around(disc, spacing, 3), spacing, 2.9);
  Box<2> const box{{-0.6, -0.6}, {0.6, 0.6}};
  auto const cut = box - Ball<2>{.centre = {0.6, 0.6}, .radius = 0.5};
  check_full_support(fill_lattice(cut, spacing), wall_around(cut, spacing, 3), spacing, 2.9);
  Ball<3> const sphere{.centre = {0, 0, 0}, .radius = 0.21};
  check_full_support(fill_lattice(sphere, spacing), wall_around(sphere, spacing, 3), spacing, 2.9);
}

TEST_CASE("walls: a floor of limited extent under all of space") {
  double const spacing = 0.1;
  HalfSpace<2> const above{.point = {0, 0}, .normal = {0, -1}};
  auto const floor = wall_around(above, spacing, 3, Box<2>{{-0.5, -9}, {1.5, 9}});
  REQUIRE(floor.size() == 20 * 3);
  CHECK((floor[0] - Vec<2, double>(-0.45, -0.25)).norm() < 1e-12);
  CHECK((floor.back() - Vec<2, double>(1.45, -0.05)).norm() < 1e-12);
  // An open box: floor and sides, no lid.
  double const infinity = std::numeric_limits<double>::infinity();
  Box<2> const open{{0, 0}, {1, infinity}};
  auto const walls = wall_around(open, spacing, 2, Box<2>{{-infinity, -infinity}, {infinity, 0.5}});
  CHECK(walls.size() == 10 * 2 + 2 * 5 * 2 + 2 * 3);
  for (auto const& x : walls) CHECK(x[1] < 0.5);
  // Below a ceiling, the lattice starts at the ceiling.
  HalfSpace<2> const under{.point = {0, 0.33}, .normal = {0, 1}};
  for (auto const& x : wall_around(under, spacing, 1, Box<2>{{0, -1}, {1, 1}})) CHECK(std::abs(x[1] - 0.38) < 1e-12);
}

TEST_CASE("walls: rings continue those of a disc") {
  double const spacing = 0.05;
  for (double const radius : {0.4, 0.98, 1.01}) {
    Ball<2> const drum{.centre = {0.1, 0.2}, .radius = radius};
    CAPTURE(radius);
    auto const material = fill_rings(drum, spacing).points, wall = wall_rings(drum, spacing, 3);
    CHECK(same_points(joined(material, wall), fill_rings(Ball<2>{drum.centre, radius + 3 * spacing}, spacing).points,
                      1e-9));
    for (auto const& x : wall) {
      double const row = drum.signed_distance(x) / spacing;
      CHECK((std::abs(row - 0.5) < 1e-9 || std::abs(row - 1.5) < 1e-9 || std::abs(row - 2.5) < 1e-9));
    }
  }
  CHECK(wall_rings(Ball<2>{.centre = {0, 0}, .radius = 1}, 0.05, 1).size() == 129);  // 2 pi 20.5 = 128.8
}

TEST_CASE("walls: rings and discs at the ends continue those of a cylinder") {
  double const spacing = 0.1;
  for (int axis = 0; axis < 3; ++axis) {
    Cylinder const drum{.axis = axis, .centre = {1, 2, 3}, .radius = 0.42, .from = -0.2, .to = 0.3};
    auto const inside = fill_rings(drum, spacing).points;
    auto longer = drum, wider = drum;
    wider.radius += 2 * spacing;
    longer.radius += 2 * spacing;
    longer.from -= 2 * spacing;
    longer.to += 2 * spacing;
    CAPTURE(axis);
    CHECK(same_points(joined(inside, wall_rings(drum, spacing, 2)), fill_rings(wider, spacing).points, 1e-9));
    CHECK(same_points(joined(inside, wall_rings(drum, spacing, 2, EndWalls::discs)), fill_rings(longer, spacing).points,
                      1e-9));
  }
}

TEST_CASE("walls: wrong requests are said") {
  Ball<2> const disc{.centre = {0, 0}, .radius = 1};
  HalfSpace<2> const above{.point = {0, 0}, .normal = {0, -1}};
  CHECK_THROWS_AS(wall_around(disc, 0.1, 0), std::invalid_argument);
  CHECK_THROWS_AS(wall_around(disc, 0, 3), std::invalid_argument);
  CHECK_THROWS_AS(wall_around(above, 0.1, 3), std::invalid_argument);
  CHECK_THROWS_AS(wall_rings(disc, 0.1, -1), std::invalid_argument);
  CHECK_THROWS_AS(wall_rings(disc, -0.1, 3), std::invalid_argument);
  CHECK_THROWS_AS(wall_rings(Cylinder{.axis = -1, .centre = {0, 0, 0}, .radius = 1, .from = 0, .to = 1}, 0.1, 3),
                  std::invalid_argument);
}

}  // namespace scree::test::walls_tests
