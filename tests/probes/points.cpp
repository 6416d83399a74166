// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "still.hpp"

#include <scree/probes/points.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <limits>

namespace scree::test::points_tests {
using namespace fields;
namespace {

template <int Dim>
std::vector<Vec<Dim, double>> at(std::initializer_list<Vec<Dim, double>> points) {
  return points;
}
bool near(double a, double b, double by) { return std::abs(a - b) <= by; }

TEST_CASE("the mean of a linear field at points within the material is its value there") {
  auto block = unit_block<2>();
  block.set(concentration, [](auto const& x) { return 1 + 2 * x[0] - 3 * x[1]; });
  block.set(velocity, [](auto const& x) { return Vec<2, double>(x[1], -x[0]); });
  for (auto const& x : at<2>({{0.5, 0.5}, {0.55, 0.55}, {0.5, 0.45}})) {
    auto const scalar = mean_at(block, concentration, {x})[0];
    CHECK(near(scalar.value, 1 + 2 * x[0] - 3 * x[1], 1e-12));  // on a point of symmetry of the lattice
    CHECK(near(scalar.weight, 1, 0.02));
    CHECK(norm(Vec<2, double>(mean_at(block, velocity, {x})[0].value - Vec<2, double>(x[1], -x[0]))) < 1e-12);
  }
  auto const off_the_lattice = mean_at(block, concentration, {{0.47, 0.52}})[0];
  CHECK(near(off_the_lattice.value, 1 + 0.94 - 1.56, 0.01));
}

TEST_CASE("a constant field has its value at a surface, where the weight is about one half, and none far away") {
  auto block = unit_block<3, float>();
  block.set(concentration, [](auto const&) { return 0.25f; });
  auto const means = mean_at(block, concentration, at<3>({{0.5, 0.5, 0.5}, {0.5, 0.5, 1}, {0.5, 0.5, 1.5}}));
  CHECK(near(means[0].value, 0.25, 1e-6));
  CHECK(near(means[1].value, 0.25, 1e-6));
  CHECK(near(means[0].weight, 1, 0.02));
  CHECK(near(means[1].weight, 0.5, 0.1));
  CHECK(std::isnan(means[2].value));
  CHECK(means[2].weight == 0);
}

TEST_CASE("the mean at points sees through periods") {
  auto block = unit_block<2>({{.axis = 0, .low = 0, .high = 1}});
  block.set(concentration, [](auto const& x) { return x[0] < 0.5 ? 0.0 : 1.0; });
  auto const means = mean_at(block, concentration, at<2>({{0, 0.5}, {1, 0.5}, {-1, 0.5}}));
  for (auto const& mean : means) {
    CHECK(near(mean.value, 0.5, 1e-12));
    CHECK(near(mean.weight, 1, 0.02));
  }
}

TEST_CASE("a derived field has its mean at points") {
  auto block = unit_block<2>();
  block.set(stress, [](auto const& x) { return Vec<4, double>(-1 - x[1], -2 - x[1], -3 - x[1], 7); });
  CHECK(near(mean_at(block, pressure, {{0.5, 0.5}})[0].value, 2.5, 1e-12));
}

TEST_CASE("points along a line include both ends") {
  auto const line = points_along<2>({1, 2}, {3, -2}, 5);
  REQUIRE(line.size() == 5);
  CHECK(line.front() == Vec<2, double>(1, 2));
  CHECK(line[1] == Vec<2, double>(1.5, 1));
  CHECK(line.back() == Vec<2, double>(3, -2));
  CHECK_THROWS_AS(points_along<2>({0, 0}, {1, 0}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace scree::test::points_tests
