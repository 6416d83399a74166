// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "still.hpp"

#include <scree/probes/coarse_grained.hpp>
#include <scree/probes/points.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>
#include <string>

namespace scree::test::coarse_grained_tests {
using namespace fields;
namespace {

bool near(double a, double b, double by) { return std::abs(a - b) <= by; }
CoarseGrid<2> const fine{.box = {{-0.05, -0.05}, {1.05, 1.05}}, .cell = {0.1, 0.11}};
CoarseGrid<3> const coarse{.box = {{0, 0, 0}, {1, 1, 1}}, .cell = {0.25, 0.2, 0.25}};

/// Moves particles by up to a fifth of their spacing, in no order.
template <class S>
void disorder(S& block) {
  int k = 0;
  block.set(position, [&](auto x) {
    for (int axis = 0; axis < int(x.size()); ++axis) {
      double const chance = std::fmod(0.618033988749895 * ++k * (axis + 1.7), 1);
      x[axis] += typename decltype(x)::Scalar(0.04 * (chance - 0.5));
    }
    return x;
  });
}

}  // namespace

TEMPLATE_TEST_CASE("a constant field is coarse-grained to itself, at walls, surfaces and in disorder", "", float,
                   double) {
  double const by = std::is_same_v<TestType, double> ? 1e-11 : 1e-7;
  auto plane = unit_block<2, TestType>();
  disorder(plane);
  plane.set(concentration, [](auto const&) { return TestType(0.7); });
  for (bool const linear : {false, true}) {
    auto grid = fine;
    grid.linear = linear;
    auto const found = coarse_grained(plane, grid, Fields<Concentration>{});
    REQUIRE(found[concentration].size() == 110);
    for (double const C : found[concentration]) CHECK(near(C, 0.7, by));
  }
  auto space = unit_block<3, TestType>();
  space.set(velocity, [](auto const&) { return Vec<3, TestType>(1, -2, 3); });
  auto const found = coarse_grained(space, coarse, Fields<Velocity>{});
  REQUIRE(found[velocity].size() == 80);
  for (auto const& u : found[velocity]) CHECK(norm(Vec<3, double>(u - Vec<3, double>(1, -2, 3))) < 30 * by);
}

TEMPLATE_TEST_CASE("a linear field is coarse-grained to itself with linear = true, and not without", "", float,
                   double) {
  double const by = std::is_same_v<TestType, double> ? 1e-11 : 3e-6;
  auto plane = unit_block<2, TestType>();
  disorder(plane);
  plane.set(concentration, [](auto const& x) { return 1 + 2 * x[0] - 3 * x[1]; });
  auto grid = fine;
  auto const exact = coarse_grained(plane, grid, Fields<Concentration>{});
  grid.linear = false;
  auto const mean = coarse_grained(plane, grid, Fields<Concentration>{});
  double worst = 0;
  auto const points = grid.points();
  for (std::size_t k = 0; k < points.size(); ++k) {
    double const expected = 1 + 2 * points[k][0] - 3 * points[k][1];
    CHECK(near(exact[concentration][k], expected, by));
    worst = std::max(worst, std::abs(mean[concentration][k] - expected));
  }
  CHECK(worst > 0.1);  // in corners

  auto space = unit_block<3, TestType>();
  disorder(space);
  space.set(stress, [](auto const& x) {
    Vec<6, TestType> s;
    for (int k = 0; k < 6; ++k) s[k] = (k + 1) * x[2] - x[k % 3];
    return s;
  });
  auto const tensor = coarse_grained(space, coarse, Fields<Stress, Pressure>{});
  auto const centres = coarse.points();
  for (std::size_t k = 0; k < centres.size(); ++k) {
    for (int c = 0; c < 6; ++c) CHECK(near(tensor[stress][k][c], (c + 1) * centres[k][2] - centres[k][c % 3], 3 * by));
    CHECK(near(tensor[pressure][k], -(6 * centres[k][2] - centres[k][0] - centres[k][1] - centres[k][2]) / 3, 3 * by));
  }
}

TEST_CASE("without linear = true the values and weights are those of mean_at()") {
  for (bool const periodic : {false, true}) {
    auto block =
        unit_block<2>(periodic ? std::vector<Period>{{.axis = 0, .low = 0, .high = 1}} : std::vector<Period>());
    disorder(block);
    block.set(concentration, [](auto const& x) { return std::sin(7 * x[0]) * x[1]; });
    auto grid = fine;
    grid.linear = false;
    auto const found = coarse_grained(block, grid, Fields<Concentration>{});
    auto const means = mean_at(block, concentration, grid.points());
    for (std::size_t k = 0; k < means.size(); ++k) {
      CHECK(near(found[concentration][k], means[k].value, 1e-11));
      CHECK(near(found.weight[k], means[k].weight, 1e-11));
    }
  }
}

TEST_CASE("coarse-graining sees through periods, wherever the grid is") {
  auto block = unit_block<2>({{.axis = 0, .low = 0, .high = 1}});
  block.set(concentration, [](auto const& x) { return x[0] < 0.5 ? 0.0 : 1.0; });
  for (double const by : {0.0, 1.0, -7.0}) {
    auto const found =
        coarse_grained(block, {.box = {{by - 0.1, 0.4}, {by + 0.1, 0.6}}, .cell = {0.2, 0.2}}, Fields<Concentration>{});
    CHECK(near(found[concentration][0], 0.5, 1e-11));
    CHECK(near(found.weight[0], 1, 0.02));
  }
  CHECK_THROWS_AS(
      coarse_grained(block, {.box = {{0, 0}, {1, 1}}, .cell = {0.5, 0.5}, .width = 0.3}, Fields<Concentration>{}),
      std::invalid_argument);
}

TEST_CASE("a wider kernel averages more, and a point without particles has no value") {
  auto block = unit_block<2>();
  block.set(concentration, [](auto const& x) { return x[1] < 0.5 ? 0.0 : 1.0; });
  auto const at = [&](double width, double z) {
    return coarse_grained(block, {.box = {{0.4, z - 0.1}, {0.6, z + 0.1}}, .cell = {0.2, 0.2}, .width = width},
                          Fields<Concentration>{});
  };
  CHECK(at(0, 0.85)[concentration][0] == 1);
  CHECK(at(0.3, 0.75)[concentration][0] < 0.99);
  CHECK(std::isnan(at(0, 1.5)[concentration][0]));
  CHECK(at(0, 1.5).weight[0] == 0);
}

TEST_CASE("particles in a row have their mean where the field cannot be known") {
  auto block = unit_block<2>();
  block.set(position, [](auto const& x) { return Vec<2, double>(x[0] + 0.003 * x[1], 0.5); });
  block.set(concentration, [](auto const& x) { return x[0]; });
  auto const found =
      coarse_grained(block, {.box = {{0.45, 0.45}, {0.55, 0.65}}, .cell = {0.1, 0.2}}, Fields<Concentration>{});
  CHECK(near(found[concentration][0], 0.5, 5e-3));
}

TEST_CASE("the mean across an axis is weighted by the filling") {
  auto space = unit_block<3>();
  space.set(concentration, [](auto const& x) { return x[2] + (x[0] - 0.5) * (x[1] - 0.5); });
  auto const found = coarse_grained(space, coarse, Fields<Concentration, Velocity>{});
  auto const plane = averaged_across(1, found);
  REQUIRE(plane.grid.size() == 16);
  CHECK(plane.grid.points()[5] == Vec<3, double>(0.375, 0.5, 0.375));
  auto const profile = averaged_across(0, plane);
  REQUIRE(profile.weight.size() == 4);
  auto const points = profile.grid.points();
  for (std::size_t k = 0; k < 4; ++k) CHECK(near(profile[concentration][k], points[k][2], 0.01));
  CHECK(profile[velocity][0] == Vec<3, double>::Zero());

  auto heap = unit_block<2>();  // a step: the right half is empty above 0.5
  heap.set(position, [](auto const& x) { return x[0] > 0.5 && x[1] > 0.5 ? Vec<2, double>(x[0], x[1] + 50) : x; });
  heap.set(concentration, [](auto const& x) { return x[1]; });
  auto const steps =
      averaged_across(0, coarse_grained(heap, {.box = {{0, 0}, {1, 1}}, .cell = {0.1, 0.1}}, Fields<Concentration>{}));
  CHECK(near(steps.weight[2], 0.95, 0.03));
  CHECK(near(steps.weight[7], 0.5, 0.03));
  CHECK(near(steps[concentration][7], 0.75, 1e-10));
  CHECK_THROWS_AS(averaged_across(2, steps), std::invalid_argument);
  CHECK_THROWS_AS(averaged_across(-1, steps), std::invalid_argument);
}

TEST_CASE("coarse grids that show nothing are refused with what is wrong") {
  auto block = unit_block<2>();
  auto const message = [&](CoarseGrid<2> const& grid) {
    try {
      coarse_grained(block, grid, Fields<Concentration>{});
    } catch (std::invalid_argument const& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  double const nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(message({.box = {{0, 0}, {1, 1}}, .cell = {0.1, 0.05}}) ==
        "scree: cell[1] (m) of a coarse grid must be the spacing of the particles, 0.1, or more, not 0.05");
  CHECK(message({.box = {{0, 0}, {1, 1}}}).find("cell[0] (m) of a coarse grid") != std::string::npos);
  CHECK(message({.box = {{0, 1}, {1, 1}}, .cell = {0.1, 0.1}}) ==
        "scree: the size (m) of a coarse grid along axis 1 must be above 0, not 0");
  CHECK(message({.box = {{0, 0}, {1, nan}}, .cell = {0.1, 0.1}}) != "");
  CHECK(message({.box = {{0, 0}, {1, 1}}, .cell = {0.1, 0.1}, .width = 0.09}).find("width (m)") != std::string::npos);
  CHECK(message({.box = {{0, 0}, {1, 1}}, .cell = {0.1, 0.1}, .width = nan}).find("width (m)") != std::string::npos);
  CHECK(message({.box = {{0, 0}, {1e6, 1e6}}, .cell = {0.1, 0.1}}).find("number of points") != std::string::npos);
  block.set(concentration, [&](auto const& x) { return x[0] < 0.1 ? nan : 1; });
  CHECK_THROWS_AS(coarse_grained(block, fine, Fields<Concentration>{}), std::runtime_error);
}

}  // namespace scree::test::coarse_grained_tests
