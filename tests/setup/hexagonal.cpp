// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/hexagonal.hpp>
#include <scree/setup/shapes.hpp>

#include "distances.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <numbers>

namespace scree::test::hexagonal_tests {
namespace {
double const distance_2d = std::sqrt(2 / std::sqrt(3.0)), distance_3d = std::pow(2.0, 1.0 / 6);
}  // namespace

TEST_CASE("hexagonal: six neighbours at one distance in a plane") {
  double const spacing = 0.1, distance = spacing * distance_2d;
  Ball<2> const disc{.centre = {0.2, 0.1}, .radius = 1};
  auto const points = fill_hexagonal(disc, spacing);
  CHECK(std::abs(least_distance(points) - distance) < 1e-12);
  int deep = 0;
  for (auto const& x : points) {
    if (disc.signed_distance(x) > -1.5 * distance) continue;
    ++deep;
    CHECK(number_within(points, x, distance * (1 + 1e-9)) == 7);
    CHECK(number_within(points, x, distance * 1.7) == 7);  // the next ones at sqrt(3)
  }
  CHECK(deep > 200);
}

TEST_CASE("hexagonal: twelve neighbours at one distance in space") {
  double const spacing = 0.1, distance = spacing * distance_3d;
  Ball<3> const sphere{.centre = {0.2, 0.1, 0}, .radius = 0.6};
  auto const points = fill_hexagonal(sphere, spacing);
  CHECK(std::abs(least_distance(points) - distance) < 1e-12);
  int deep = 0, at_two_layers = 0;
  for (auto const& x : points) {
    if (sphere.signed_distance(x) > -1.7 * distance) continue;
    ++deep;
    CHECK(number_within(points, x, distance * (1 + 1e-9)) == 13);
    CHECK(number_within(points, x, distance * 1.4) == 13);  // the next ones at sqrt(2)
    // Hexagonal, not cubic, close packing: two at sqrt(8/3), straight above and below.
    at_two_layers += number_within(points, x, distance * 1.64) - number_within(points, x, distance * 1.5);
  }
  CHECK(deep > 200);
  CHECK(at_two_layers == 2 * deep);
}

TEST_CASE("hexagonal: as many particles as fit the area and volume") {
  for (double const radius : {10.0, 20.3, 40.7}) {  // in spacings
    double const area = std::numbers::pi * radius * radius;
    auto const number = double(fill_hexagonal(Ball<2>{.centre = {0, 0}, .radius = radius}, 1).size());
    CAPTURE(radius, number, area);
    CHECK(std::abs(number - area) < 4 * std::sqrt(radius));
  }
  double const volume = 4 * std::numbers::pi / 3 * 20 * 20 * 20;
  auto const number = double(fill_hexagonal(Ball<3>{.centre = {0, 0, 0}, .radius = 20}, 1).size());
  CHECK(std::abs(number / volume - 1) < 0.005);
}

TEST_CASE("hexagonal: a box that fits is filled exactly and looks the same from opposite sides") {
  double const spacing = 0.1, distance = spacing * distance_2d, pitch = distance * std::sqrt(3.0) / 2;
  Box<2> const box{{-1, 2}, {-1 + 12 * distance, 2 + 10 * pitch}};
  auto const points = fill_hexagonal(box, spacing);
  CHECK(points.size() == 12 * 10);
  auto turned = points;
  for (auto& x : turned) x = box.low + box.high - x;
  CHECK(same_points(points, turned, 1e-12));
  for (auto const& x : points) CHECK(box.signed_distance(x) < -0.24 * distance);
  double const a = distance_3d;
  Box<3> const block{{0, 0, 0}, {8 * a, 6 * a * std::sqrt(3.0) / 2, 4 * a * std::sqrt(2.0 / 3)}};
  CHECK(fill_hexagonal(block, 1).size() == 8 * 6 * 4);
}

TEST_CASE("hexagonal: what cannot be filled is said") {
  CHECK_THROWS_AS(fill_hexagonal(HalfSpace<2>{.point = {0, 0}, .normal = {0, 1}}, 0.1), std::invalid_argument);
  CHECK_THROWS_AS(fill_hexagonal(Ball<2>{.centre = {0, 0}, .radius = 1}, 0), std::invalid_argument);
}

}  // namespace scree::test::hexagonal_tests
