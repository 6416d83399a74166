// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/checks/points_in_cells.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace scree::test::points_in_cells_tests {
namespace {

using Cells = detail::PointsInCells;
using Point = Cells::Point;

std::vector<Point> scattered(std::size_t count, double extent, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> anywhere(-extent, extent);
  std::vector<Point> points(count);
  for (auto& x : points)
    for (double& each : x) each = anywhere(generator);
  return points;
}

}  // namespace

TEST_CASE("points near a box, also displaced ones, are those that a search of all finds, each once") {
  auto points = scattered(3000, 5, 1);
  double const infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
  for (Point const& x : {Point{1e300, 0, 0}, Point{nan, 1, 1}, Point{0, -infinity, 2}, Point{1, 1, 1e17}})
    points.push_back(x);
  Cells const cells(points, 100, points.size(), 0.7);
  for (Point const& shift : {Point{}, Point{3, 0, -1}, Point{0, 40, 0}})
    for (Point const& x : scattered(50, 6, 2)) {
      Cells::Hull box;
      box.add(x), box.add({x[0] + 0.4, x[1], x[2] + 1.1});
      std::vector<int> found(points.size(), 0), expected(points.size(), 0);
      std::vector<Cells::Numbered> near;
      cells.add_near(box, 0.6, shift, near);
      for (auto const& p : near) ++found[p.number];
      for (std::size_t i = 100; i < points.size(); ++i) {
        double squared = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          double const at = points[i][axis] + shift[axis];
          squared += std::pow(at < box.low[axis]    ? box.low[axis] - at
                              : at > box.high[axis] ? at - box.high[axis]
                                                    : 0,
                              2);
        }
        expected[i] = squared < 0.36 && std::isfinite(points[i][0]) ? 1 : 0;
      }
      CHECK(found == expected);
    }
}

TEST_CASE("cells hold each point once, in ascending order, and as many as are kept") {
  auto const points = scattered(5000, 5, 3);
  Cells const cells(points, 0, points.size(), 0.9);
  std::vector<int> seen(points.size(), 0);
  for (std::size_t k = 0; k < cells.size(); ++k)
    for (auto const* p = cells.begin(k); p != cells.end(k); ++p) {
      ++seen[p->number];
      CHECK(p->x == points[p->number]);
      CHECK(Cells::cell_of(p->x, 0.9) == Cells::cell_of(cells.begin(k)->x, 0.9));
      if (p != cells.begin(k)) CHECK(p[-1].number < p->number);
    }
  CHECK(seen == std::vector<int>(points.size(), 1));

  // Of many points, those near a few.
  Cells const few(scattered(20, 5, 4), 0, 20, 0.9);
  auto const near = few.cells_near(0.5);
  Cells const kept(points, 0, points.size(), 0.9, &near);
  CHECK(kept.size() < cells.size() / 2);
  for (Point const& x : scattered(20, 5, 4)) {
    Cells::Hull here;
    here.add(x);
    std::vector<Cells::Numbered> all, among_kept;
    cells.add_near(here, 0.5, {}, all);
    kept.add_near(here, 0.5, {}, among_kept);
    CHECK(all.size() == among_kept.size());
  }
}

}  // namespace scree::test::points_in_cells_tests
