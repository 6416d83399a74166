// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/checks/near_cells.hpp>

#include <scree/system/pick.hpp>

#include <support/bodies.hpp>
#include <support/policies.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <limits>
#include <set>

namespace scree::test::near_cells_tests {
using namespace fields;

namespace {

/// The numbers of the points that may be within a width of others.
template <class P>
std::set<int> picked(Points<P::dim> const& points, std::vector<scree::detail::PointsInCells::Point> const& others,
                     double width) {
  auto const body = body_of<P>(points, 1);
  auto const marks = array_of<P>(body.space(), scree::detail::marks_around(others, width));
  auto const found = values_of(pick(body, scree::detail::MaybeNear{marks, width}));
  return {found.begin(), found.end()};
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("all particles near some points are picked, and few of the others", "", Policies) {
  using P = TestType;
  auto const points = random_points<P::dim>(4000, -1, 1, 1);
  for (double const width : {0.02, 0.1, 0.5}) {
    std::vector<scree::detail::PointsInCells::Point> others;
    for (auto const& x : random_points<P::dim>(20, -1, 1, 2))
      others.push_back({x[0], x[1], P::dim == 3 ? x[P::dim - 1] : 0});
    auto const found = picked<P>(points, others, width);
    std::size_t near = 0, around = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      bool is_near = false, is_around = false;  // within a width, and within two along each axis
      for (auto const& y : others) {
        double squared = 0, most = 0;
        for (int axis = 0; axis < P::dim; ++axis) {
          double const by = double(typename P::real(points[i][axis])) - y[std::size_t(axis)];
          squared += by * by, most = std::max(most, std::abs(by));
        }
        is_near = is_near || squared < width * width, is_around = is_around || most < 2 * width;
      }
      near += is_near, around += is_around;
      if (is_near) REQUIRE(found.count(int(i)) == 1);
    }
    INFO(near << " of " << points.size() << " are near, " << around << " around, " << found.size() << " picked");
    CHECK(found.size() <= around + points.size() / 10);
  }
}

TEST_CASE("without points none is picked, and positions that are not finite do no harm") {
  using P = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
  double const infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  Points<2> const points{{0, 0}, {nan, 0}, {infinity, -infinity}, {1e300, 0}, {-0.05, 0}};
  CHECK(picked<P>(points, {}, 0.1).empty());
  CHECK(picked<P>(points, {{0, 0, 0}, {nan, 0, 0}, {infinity, 0, 0}}, 0.1).count(0) == 1);
  CHECK(picked<P>(points, {{0, 0, 0}}, 0.1).count(4) == 1);
}

}  // namespace scree::test::near_cells_tests
