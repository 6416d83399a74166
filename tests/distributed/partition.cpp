// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/distributed/partition.hpp>

#include <support/points.hpp>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>

namespace scree::test::partition_tests {
namespace {

CellWeights<2> weights_of(Points<2> const& points, double edge) {
  auto grid = CellWeights<2>::over({0, 0}, {4, 1}, edge);
  CellOfPosition<2> const cell(grid);
  for (auto const& x : points) ++grid.weights[std::size_t(cell(x))];
  return grid;
}
std::vector<std::int64_t> loads_of(Partition<2> const& partition, Points<2> const& points) {
  std::vector<std::int64_t> loads(std::size_t(partition.ranks()), 0);
  for (auto const& x : points) ++loads.at(std::size_t(partition.owner(x)));
  return loads;
}
/// Random points, most of them on the left.
Points<2> dense_on_the_left(int count) {
  auto points = random_points<2>(count, 0, 1, 1);
  for (auto& x : points) x[0] *= 4 * x[0];
  return points;
}
bool same(Partition<2> const& a, Partition<2> const& b) {
  return std::equal(a.planes().begin(), a.planes().end(), b.planes().begin(), b.planes().end(),
                    [](auto const& one, auto const& other) {
                      return one.axis == other.axis && one.cut == other.cut && one.below == other.below &&
                             one.above == other.above;
                    });
}

}  // namespace

TEST_CASE("a partition gives each rank about the same work", "") {
  auto const points = dense_on_the_left(20000);
  auto const grid = weights_of(points, 0.01);
  for (int ranks = 1; ranks <= 9; ++ranks) {
    CHECK(imbalance(loads_of(Partition<2>::bisection(grid, ranks), points)) < 1.1);
    CHECK(imbalance(loads_of(Partition<2>::slabs(grid, ranks, 0), points)) < 1.1);
    CHECK(imbalance(loads_of(Partition<2>::slabs(grid, ranks, 1), points)) < 1.1);
  }
}

TEST_CASE("ranks are as equal where they are a few cells wide", "") {
  auto points = random_points<2>(20000, 0, 1, 1);
  for (auto& x : points) x[0] *= 4;
  auto const grid = weights_of(points, 0.4);  // 11 by 3 cells
  for (int ranks = 2; ranks <= 9; ++ranks) {
    CHECK(imbalance(loads_of(Partition<2>::bisection(grid, ranks), points)) < 1.04);
    CHECK(imbalance(loads_of(Partition<2>::slabs(grid, ranks, 0), points)) < 1.04);
  }
}

TEST_CASE("slabs cut one axis, bisection the longest", "") {
  auto const points = dense_on_the_left(2000);
  auto const grid = weights_of(points, 0.02);
  auto const slabs = Partition<2>::slabs(grid, 5, 1).planes();
  for (auto const& plane : slabs) CHECK(plane.axis == 1);
  auto const planes = Partition<2>::bisection(grid, 8).planes();
  CHECK(planes.size() == 7);
  CHECK(planes[0].axis == 0);
  CHECK(std::any_of(planes.begin(), planes.end(), [](auto const& plane) { return plane.axis == 1; }));
}

TEST_CASE("a partition does not depend on the order in which particles are counted", "") {
  auto points = dense_on_the_left(5000);
  auto const before = Partition<2>::bisection(weights_of(points, 0.02), 7);
  std::reverse(points.begin(), points.end());
  CHECK(same(Partition<2>::bisection(weights_of(points, 0.02), 7), before));
}

TEST_CASE("with more ranks than cells some ranks stay empty, and every position has a rank", "") {
  Points<2> points(100, Vec<2, double>(0.5, 0.5));
  for (auto const& partition :
       {Partition<2>::bisection(weights_of(points, 0.5), 40), Partition<2>::slabs(weights_of(points, 0.5), 40, 1)}) {
    auto const loads = loads_of(partition, points);
    CHECK(std::count(loads.begin(), loads.end(), 0) == 39);
    CHECK(std::count(loads.begin(), loads.end(), 100) == 1);
    for (auto const& x : random_points<2>(100, -50, 50, 1)) CHECK(partition.owner(x) < 40);
  }
  CHECK(Partition<2>::bisection(CellWeights<2>::over({0, 0}, {0, 0}, 1), 3).ranks() == 3);
}

TEST_CASE("weights of particles beyond an int are divided", "") {
  auto grid = CellWeights<2>::over({0, 0}, {3.5, 0.5}, 1);
  REQUIRE(grid.weights.size() == 4);
  grid.weights = {std::int64_t(5) << 32, std::int64_t(1) << 32, std::int64_t(1) << 32, std::int64_t(3) << 32};
  auto const halves = Partition<2>::slabs(grid, 2, 0);
  CHECK(halves.planes()[0].cut == 1);
}

TEST_CASE("cells grow where there would be too many", "") {
  auto const grid = CellWeights<3>::over({0, 0, 0}, {1, 1, 1}, 1e-3, 1000);
  CHECK(grid.weights.size() <= 1000);
  CHECK(grid.edge > 0.1);
}

TEST_CASE("settings of a partition out of their range are refused", "") {
  auto const grid = CellWeights<2>::over({0, 0}, {1, 1}, 0.1);
  CHECK_THROWS_AS(Partition<2>::bisection(grid, 0), std::invalid_argument);
  for (int const axis : {-1, 2}) CHECK_THROWS_AS(Partition<2>::slabs(grid, 2, axis), std::invalid_argument);
  CHECK_THROWS_AS(CellWeights<2>::over({0, 0}, {1, 1}, 0), std::invalid_argument);
}

TEST_CASE("the imbalance is the largest load over the mean", "") {
  CHECK(imbalance({1, 1, 4}) == Catch::Approx(2));
  CHECK(imbalance({0, 0}) == 1);
}

}  // namespace scree::test::partition_tests
