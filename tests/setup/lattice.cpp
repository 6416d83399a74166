// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/lattice.hpp>

#include <catch2/catch_test_macros.hpp>

namespace scree::test::lattice_tests {
namespace {
Box<2> const sheet{{-1, 2}, {-0.4, 2.3}};
Box<3> const block{{0, 0, 0}, {0.4, 0.3, 0.2}};
}  // namespace

TEST_CASE("a box is filled with the centres of cubes, the first coordinate fastest") {
  auto const points = fill_lattice(sheet, 0.1);
  REQUIRE(points.size() == 6 * 3);
  CHECK((points[0] - Vec<2, double>(-0.95, 2.05)).norm() < 1e-15);
  CHECK((points[1] - Vec<2, double>(-0.85, 2.05)).norm() < 1e-15);
  CHECK((points[6] - Vec<2, double>(-0.95, 2.15)).norm() < 1e-15);
  CHECK((points.back() - Vec<2, double>(-0.45, 2.25)).norm() < 1e-15);
  auto const cubes = fill_lattice(block, 0.1);
  REQUIRE(cubes.size() == 4 * 3 * 2);
  CHECK((cubes[4 * 3 + 4 + 1] - Vec<3, double>(0.15, 0.15, 0.15)).norm() < 1e-15);
  for (auto const& x : cubes) CHECK(block.contains(x));
}

TEST_CASE("the number of particles along an axis is rounded") {
  CHECK(fill_lattice(sheet, 0.11).size() == 5 * 3);  // 0.6/0.11 = 5.45, 0.3/0.11 = 2.7
  CHECK(fill_lattice(Box<2>{{0, 0}, {0.04, 1}}, 0.1, Vec<2, double>(0, 0)).empty());
}

TEST_CASE("a box is filled with the same bits wherever its particles are computed") {
  // The code from before shapes other than boxes could be filled; results of earlier runs depend on it.
  Box<3> const box{{0.1, -1.0 / 3, 7}, {0.1 + 0.7, 1.0 / 7, 7.45}};
  double const spacing = 0.1 / 3;
  std::vector<Vec<3, double>> expected;
  long const count[] = {21, 14, 14};  // 0.7, 0.476 and 0.45 over 1/30: 21, 14.3, 13.5
  for (long k = 0; k < count[2]; ++k)
    for (long j = 0; j < count[1]; ++j)
      for (long i = 0; i < count[0]; ++i)
        expected.push_back({box.low[0] + spacing * (double(i) + 0.5), box.low[1] + spacing * (double(j) + 0.5),
                            box.low[2] + spacing * (double(k) + 0.5)});
  CHECK(fill_lattice(box, spacing) == expected);
}

TEST_CASE("walls are what lies around the inner box, on the same lattice") {
  Box<2> const inner{{0, 0}, {0.5, 0.3}}, outer{{-0.2, -0.2}, {0.7, 0.5}};
  auto const walls = fill_between(inner, outer, 0.1);
  CHECK(walls.size() == 9 * 7 - 5 * 3);
  for (auto const& x : walls) CHECK_FALSE(inner.contains(x));
  // Together with the inner particles they form the whole lattice.
  auto const material = fill_lattice(inner, 0.1);
  for (auto const& x : fill_lattice(outer, 0.1)) {
    int found = 0;
    for (auto const& y : walls) found += (x - y).norm() < 1e-12;
    for (auto const& y : material) found += (x - y).norm() < 1e-12;
    CHECK(found == 1);
  }
}

TEST_CASE("jitter moves every point a little, the same way for the same seed") {
  auto const points = fill_lattice(block, 0.02);
  auto once = points, again = points, other = points;
  jitter(once, 0.002, 7);
  jitter(again, 0.002, 7);
  jitter(other, 0.002, 8);
  CHECK(once == again);
  CHECK(once != other);
  double largest = 0;
  Vec<3, double> mean = Vec<3, double>::Zero();
  for (std::size_t k = 0; k < points.size(); ++k) {
    Vec<3, double> const by = once[k] - points[k];
    largest = std::max(largest, by.lpNorm<Eigen::Infinity>());
    mean += by / double(points.size());
  }
  CHECK(largest <= 0.002);
  CHECK(largest > 0.0019);
  // 3000 uniform numbers of deviation 0.002/sqrt(3): five deviations of their mean.
  CHECK(mean.lpNorm<Eigen::Infinity>() < 5 * 0.002 / std::sqrt(3.0 * 3000));
}

TEST_CASE("jitter is the same on every platform") {
  // The first output of mt19937_64 with its default seed 5489 is 14514284786278117030 (checked by the standard's
  // 10000th, 9981545732273789042, [rand.predef]).
  std::mt19937_64 engine;
  engine.discard(9999);
  CHECK(engine() == 9981545732273789042ULL);
  std::vector<Vec<2, double>> point(1, Vec<2, double>::Zero());
  jitter(point, 1, 5489);
  CHECK(point[0][0] == 2 * (double(14514284786278117030ULL >> 11) / 9007199254740992.0) - 1);
}

TEST_CASE("points are cast to another precision") {
  auto const points = fill_lattice(sheet, 0.1);
  auto const floats = cast<float>(points);
  REQUIRE(floats.size() == points.size());
  CHECK(floats[7][1] == float(points[7][1]));
}

}  // namespace scree::test::lattice_tests
