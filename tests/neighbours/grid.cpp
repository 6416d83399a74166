// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/neighbours/grid.hpp>

#include <support/points.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <vector>

namespace scree::test {

TEMPLATE_LIST_TEST_CASE("a grid holds all its particles", "", Policies) {
  using P = TestType;
  auto const x = positions_of<P>(random_points<P::dim>(300, -2, 3, 1));
  auto const grid = make_grid<P>(x, 0.25);
  CHECK(double(grid.edges[0]) >= 0.25);
  for (auto const& point : to_host(x)) {
    for (int axis = 0; axis < P::dim; ++axis) {
      REQUIRE(grid.coordinate(point, axis) >= 0);
      REQUIRE(grid.coordinate(point, axis) < grid.cells[axis]);
    }
    REQUIRE(grid.index(point) < grid.size());
  }
}

TEMPLATE_LIST_TEST_CASE("a grid without particles has no cells", "", Policies) {
  using P = TestType;
  CHECK(make_grid<P>(Positions<P>(), 0.25).size() == 0);
}

TEMPLATE_LIST_TEST_CASE("cells grow rather than exceed 8 per particle and 2^16", "", Policies) {
  using P = TestType;
  Points<P::dim> points = random_points<P::dim>(50, 0, 1, 1);
  points.push_back(Vec<P::dim, double>::Constant(1e9));
  auto const x = positions_of<P>(points);
  auto const grid = make_grid<P>(x, 0.01);
  CHECK(double(grid.edges[0]) > 0.01);
  CHECK(grid.size() <= 8 * 51 + (1 << 16));
  CHECK(grid.size() > 1000);  // and not more than needed: edges double
  for (auto const& point : to_host(x)) CHECK(grid.index(point) < grid.size());
}

TEMPLATE_LIST_TEST_CASE("the rows around a position are those of its own and the adjacent cells", "", Policies) {
  using P = TestType;
  using real = typename P::real;
  using vector = Vec<P::dim, real>;
  Grid<P::dim, real> grid;
  for (int axis = 0; axis < P::dim; ++axis) grid.cells[axis] = 3 + axis;
  grid.edges.setConstant(real(0.5));
  int const last = P::dim - 1;
  for (int at = -2; at < 8; ++at) {
    vector x = vector::Constant(real(0.25));
    x[last] = real(0.5 * at + 0.25);
    std::multiset<int> visited, expected;
    grid.for_each_row_around(x, [&](int first, int end) {
      for (int cell = first; cell <= end; ++cell) visited.insert(cell);
    });
    // By hand. Cells beyond the grid do not exist; a position further outside may be given those of the nearest layer.
    for (int cell = 0; cell < grid.size(); ++cell) {
      int rest = cell;
      bool near = true;
      for (int axis = 0; axis < P::dim; rest /= grid.cells[axis], ++axis) {
        int const centre = axis == last ? std::clamp(at, -1, grid.cells[last]) : 0;
        near = near && std::abs(rest % grid.cells[axis] - centre) <= 1;
      }
      if (near) expected.insert(cell);
    }
    INFO("layer " << at);
    CHECK(visited == expected);
  }
}

TEMPLATE_LIST_TEST_CASE("the cells around a position hold all within one edge, whole or in parts", "", Policies) {
  using P = TestType;
  double const edge = 0.3;
  auto const x = positions_of<P>(random_points<P::dim>(200, -1, 1, 3));
  auto const points = to_host(x);
  for (int const parts : {1, 2, 5}) {
    auto const grid = make_grid<P>(x, edge, parts);
    CHECK(double(grid.edges[0]) * parts >= edge);
    CHECK(double(grid.edges[0]) * parts < edge * 1.001);
    CHECK(double(grid.edges[1]) >= edge);
    int missed = 0, offered = 0;
    for (auto const& xi : points) {
      std::set<int> around;
      grid.for_each_row_around(xi, [&](int first, int last) {
        for (int cell = first; cell <= last; ++cell) around.insert(cell);
      });
      for (auto const& xj : points) {
        bool const near = (xi - xj).norm()<typename P::real(edge), found = around.count(grid.index(xj))> 0;
        missed += near && !found;
        offered += found;
      }
    }
    INFO(parts << " parts: " << offered << " candidates");
    CHECK(missed == 0);
    // Along the first axis 3 edges, or 2 and a part.
    CHECK(double(offered) / 200 < 200 * std::pow(3 * edge / 2, P::dim) * (2 + 1.0 / parts) / 3 * 1.3);
  }
}

}  // namespace scree::test
