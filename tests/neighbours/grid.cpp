// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/neighbours/grid.hpp>

#include <support/points.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <cstdlib>
#include <set>
#include <vector>

namespace scree::test::grid_tests {

TEMPLATE_LIST_TEST_CASE("a grid holds all its particles", "", Policies) {
  using P = TestType;
  auto const x = positions_of<P>(random_points<P::dim>(300, -2, 3, 1));
  auto const grid = make_grid<P>(x, 0.25);
  CHECK(double(grid.edges[0]) >= 0.25);
  for (auto const& point : values_of(x)) {
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
  for (auto const& point : values_of(x)) CHECK(grid.index(point) < grid.size());
}

/// The cells a grid offers for a position, each once.
template <class Grid, class X>
std::multiset<int> cells_around(Grid const& grid, X const& x) {
  std::multiset<int> cells;
  grid.for_each_row_around(x, [&](int first, int last) {
    for (int cell = first; cell <= last; ++cell) cells.insert(cell);
  });
  return cells;
}

TEMPLATE_LIST_TEST_CASE("the rows around the centre of a cell are those of it and the adjacent cells", "", Policies) {
  using P = TestType;
  using real = typename P::real;
  using vector = Vec<P::dim, real>;
  Grid<P::dim, real> grid;
  for (int axis = 0; axis < P::dim; ++axis) grid.cells[axis] = 3 + axis;
  grid.edges.setConstant(real(0.5));
  int const last = P::dim - 1;
  for (int at = -3; at < 9; ++at) {
    vector x = vector::Constant(real(0.25));
    x[last] = real(0.5 * at + 0.25);
    std::multiset<int> expected;
    // By hand. Cells beyond the grid do not exist.
    for (int cell = 0; cell < grid.size(); ++cell) {
      int rest = cell;
      bool near = true;
      for (int axis = 0; axis < P::dim; rest /= grid.cells[axis], ++axis)
        near = near && std::abs(rest % grid.cells[axis] - (axis == last ? at : 0)) <= 1;
      if (near) expected.insert(cell);
    }
    INFO("layer " << at);
    CHECK(cells_around(grid, x) == expected);
    if (at >= 0 && at < grid.cells[last]) CHECK((grid.centre(x + vector::Constant(real(0.2))) - x).norm() < 1e-6);
  }
}

TEMPLATE_LIST_TEST_CASE("a position far outside of a grid has no cells around it", "", Policies) {
  using P = TestType;
  using vector = Vec<P::dim, typename P::real>;
  auto const grid = make_grid<P>(positions_of<P>(random_points<P::dim>(200, -1, 1, 3)), 0.3, 4);
  for (double const far : {-3.0, 3.0, 1e30, -1e30})
    for (int axis = 0; axis < P::dim; ++axis) {
      vector x = vector::Zero();
      x[axis] = typename P::real(far);
      INFO("axis " << axis << " at " << far);
      CHECK(cells_around(grid, x).empty());
    }
}

/// Fraction of 3^Dim cells of one edge that a position is offered, on average: rows through the ball, and a part.
template <int Dim>
double offered_share(double part) {
  double const pi = std::acos(-1.0), beside = pi / 2 + part, corner = pi / 3 + pi / 4 * part;
  return Dim == 2 ? (2 + part + 2 * beside) / 9 : (2 + part + 4 * beside + 4 * corner) / 27;
}

TEMPLATE_LIST_TEST_CASE("the cells around a position hold all within one edge, whole or in parts", "", Policies) {
  using P = TestType;
  double const edge = 0.3;
  auto const x = positions_of<P>(random_points<P::dim>(200, -1, 1, 3));
  auto const points = values_of(x);
  for (int const parts : {1, 2, 5}) {
    auto const grid = make_grid<P>(x, edge, parts);
    CHECK(double(grid.edges[0]) * parts >= edge);
    CHECK(double(grid.edges[0]) * parts < edge * 1.001);
    CHECK(double(grid.edges[1]) >= edge);
    int missed = 0, offered = 0;
    for (auto const& xi : points) {
      auto const around = cells_around(grid, xi);
      for (auto const& xj : points) {
        bool const near = (xi - xj).norm()<typename P::real(edge), found = around.count(grid.index(xj))> 0;
        missed += near && !found;
        offered += found;
      }
    }
    INFO(parts << " parts: " << offered << " candidates");
    CHECK(missed == 0);
    CHECK(double(offered) / 200 < 200 * std::pow(3 * edge / 2, P::dim) * offered_share<P::dim>(1.0 / parts) * 1.3);
  }
}

TEMPLATE_LIST_TEST_CASE("no source at the very edge is missed, far from the origin either", "", Policies) {
  using P = TestType;
  using real = typename P::real;
  using vector = Vec<P::dim, real>;
  real const edge = real(0.3);
  for (double const away : {0.0, 40.0}) {
    std::vector<vector> points;
    for (auto const& x : random_points<P::dim>(60, -1, 1, 5))
      points.push_back((x.array() + away).template cast<real>());
    std::size_t const centres = points.size();
    // Next to each, points just within the edge, many of them in the planes in which a row is touched.
    for (std::size_t k = 0; k < centres; ++k)
      for (auto const& way : random_points<P::dim>(40, -1, 1, 7)) {
        vector direction = way.template cast<real>();
        if (k % 2 == 0) direction[0] *= real(1e-4);
        points.push_back(points[k] + direction.normalized() * edge);
      }
    auto const grid = make_grid<P>(array_of<P>(points), double(edge), 4);
    int missed = 0, near = 0;
    for (std::size_t k = 0; k < centres; ++k) {
      auto const around = cells_around(grid, points[k]);
      for (auto const& xj : points) {
        bool const within = (points[k] - xj).norm() <= edge;
        near += within;
        missed += within && around.count(grid.index(xj)) == 0;
      }
    }
    INFO(near << " near");
    CHECK(near > 1000);
    CHECK(missed == 0);
  }
}

}  // namespace scree::test::grid_tests
