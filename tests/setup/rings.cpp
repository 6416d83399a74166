// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/lattice.hpp>
#include <scree/setup/rings.hpp>

#include "distances.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <numeric>

namespace scree::test::rings_tests {
namespace {
double area_of(double radius) { return std::numbers::pi * radius * radius; }
double sum(std::vector<double> const& values) { return std::accumulate(values.begin(), values.end(), 0.0); }
}  // namespace

TEST_CASE("rings: no two particles of a disc of any size are close") {
  for (double radius = 0.4; radius < 12; radius += 0.013) {  // in spacings
    auto const filled = fill_rings(Ball<2>{.centre = {3, -2}, .radius = radius}, 1);
    CAPTURE(radius, filled.points.size());
    CHECK(least_distance(filled.points) >= 0.8);
    for (auto const& x : filled.points) CHECK((x - Vec<2, double>(3, -2)).norm() < std::max(radius - 0.5, 0.0) + 0.24);
  }
}

TEST_CASE("rings: no place in a disc of any size is far from a particle") {
  for (double radius = 0.5; radius < 6; radius += 0.13) {  // in spacings
    Ball<2> const disc{.centre = {0, 0}, .radius = radius};
    auto const points = fill_rings(disc, 1).points;
    CAPTURE(radius);
    // Between rings, the middle of a square with sides up to 1.2 spacings; without a ring or the core it would be more
    // than 1.
    for (auto const& x : fill_lattice(offset(disc, -0.5), 0.05)) CHECK(distance_to(points, x) < 0.85);
  }
}

TEST_CASE("rings: each ring is one spacing from the next, the last one half a spacing within the edge") {
  double const spacing = 0.02;
  Ball<2> const disc{.centre = {0.5, 0.25}, .radius = 0.31};
  auto const points = fill_rings(disc, spacing).points;
  int outermost = 0, second = 0;
  for (auto const& x : points) {
    double const in_spacings = -disc.signed_distance(x) / spacing;
    outermost += std::abs(in_spacings - 0.5) < 1e-9;
    second += std::abs(in_spacings - 1.5) < 1e-9;
    if (in_spacings < 14) CHECK(std::abs(in_spacings - std::floor(in_spacings) - 0.5) < 1e-9);
    CHECK(in_spacings > 0.5 - 1e-9);
  }
  CHECK(outermost == 94);  // 2 pi 15 = 94.2
  CHECK(second == 88);     // 2 pi 14 = 88.0
}

TEST_CASE("rings: particles stand for the whole disc, each for nearly the same") {
  for (double radius = 0.5; radius < 40; radius += 0.37) {  // in spacings
    auto const filled = fill_rings(Ball<2>{.centre = {0, 0}, .radius = radius}, 1);
    CAPTURE(radius);
    REQUIRE(filled.volumes.size() == filled.points.size());
    CHECK(std::abs(sum(filled.volumes) / area_of(radius) - 1) < 1e-12);
    CHECK(std::abs(filled.nominal_number / area_of(radius) - 1) < 1e-12);
    for (std::size_t k = 0; k < filled.points.size(); ++k) {
      bool const core = filled.points[k].norm() < 0.99;
      CHECK(filled.volumes[k] > (core ? 0.75 : 0.92));
      CHECK(filled.volumes[k] < (core ? 1.8 : 1.08));
    }
    if (radius > 10) CHECK(std::abs(double(filled.points.size()) / filled.nominal_number - 1) < 0.01);
  }
}

TEST_CASE("rings: the bed of a drum is what lies below a plane") {
  double const spacing = 0.02;
  Ball<2> const drum{.centre = {0, 0}, .radius = 1};
  HalfSpace<2> const below{.point = {0, -0.2}, .normal = {0.3, 1}};
  auto const bed = fill_rings(drum, spacing, below);
  auto const rest = fill_rings(drum, spacing, complement(below));
  for (auto const& x : bed.points) CHECK(below.contains(x));
  CHECK(bed.volumes.size() == bed.points.size());
  CHECK(bed.points.size() + rest.points.size() == fill_rings(drum, spacing).points.size());
  double const distance = -below.signed_distance({0, 0}), depth = -distance;
  double const angle = std::acos(depth), segment = angle - depth * std::sin(angle);
  CHECK(std::abs(sum(bed.volumes) / segment - 1) < 0.01);
  CHECK(std::abs(double(bed.points.size()) / (segment / sq(spacing)) - 1) < 0.01);
}

TEST_CASE("rings: a cylinder has the rings of a disc in every layer") {
  double const spacing = 0.1;
  auto const disc = fill_rings(Ball<2>{.centre = {0, 0}, .radius = 0.75}, spacing).points;
  for (int axis = 0; axis < 3; ++axis) {
    Cylinder const drum{.axis = axis, .centre = {1, 2, 3}, .radius = 0.75, .from = -0.2, .to = 0.3};
    auto const filled = fill_rings(drum, spacing);
    CAPTURE(axis);
    REQUIRE(filled.points.size() == 5 * disc.size());
    CHECK(std::abs(sum(filled.volumes) / (area_of(0.75) * 0.5) - 1) < 1e-12);
    CHECK(std::abs(filled.nominal_number - area_of(7.5) * 5) < 1e-6);
    CHECK(least_distance(filled.points) >= 0.8 * spacing);
    for (auto const& x : filled.points) CHECK(drum.signed_distance(x) < -0.049);
    for (int layer = 0; layer < 5; ++layer) {
      auto const in_layer = [&](auto const& x) { return std::abs(x[axis] - (-0.15 + 0.1 * layer)) < 1e-12; };
      CHECK(std::count_if(filled.points.begin(), filled.points.end(), in_layer) == long(disc.size()));
    }
  }
  Cylinder const drum{.axis = 1, .centre = {0, 0, 0}, .radius = 0.75, .from = 0, .to = 0.3};
  auto const bed = fill_rings(drum, spacing, HalfSpace<3>{.point = {0, 0, 0}, .normal = {0, 0, 1}});
  CHECK(std::abs(double(bed.points.size()) / fill_rings(drum, spacing).nominal_number - 0.5) < 0.03);
  for (auto const& x : bed.points) CHECK(x[2] < 0);
}

TEST_CASE("rings: wrong requests are said") {
  Cylinder const nowhere{.axis = 3, .centre = {0, 0, 0}, .radius = 1, .from = 0, .to = 1};
  CHECK_THROWS_AS(fill_rings(nowhere, 0.1), std::invalid_argument);
  CHECK_THROWS_AS(fill_rings(Ball<2>{.centre = {0, 0}, .radius = 1}, 0), std::invalid_argument);
  CHECK_THROWS_AS(fill_rings(Ball<2>{.centre = {0, 0}, .radius = 0.01}, 0.1), std::invalid_argument);
}

}  // namespace scree::test::rings_tests
