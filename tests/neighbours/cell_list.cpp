// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/neighbours/cell_list.hpp>

#include <support/candidates.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

namespace scree::test::cell_list_tests {

TEMPLATE_LIST_TEST_CASE("a cell list offers nothing beyond its radius", "", Policies) {
  using P = TestType;
  double const radius = 0.1;
  auto const x = positions_of<P>(random_points<P::dim>(500, 0, 1, 1));
  CellList<P> search(radius);
  search.update(x, x);
  auto const points = values_of(x);
  auto const found = candidates<P>(search, x);
  double furthest = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (int const j : found[i])
      furthest = std::max(furthest, double((points[i] - points[static_cast<std::size_t>(j)]).norm()));
  CHECK(furthest < radius * (1 + 1e-6));
  CHECK(furthest > 0.95 * radius);
}

TEMPLATE_LIST_TEST_CASE("a cell list is built at every update", "", Policies) {
  using P = TestType;
  auto const x = positions_of<P>(random_points<P::dim>(20, 0, 1, 1));
  CellList<P> search(0.1);
  CHECK(search.builds() == 0);
  search.update(x, x);
  search.update(x, x);
  CHECK(search.builds() == 2);
}

// The origin of the cells is far away, at x = -origin, so that x - origin is rounded: of two particles slightly less
// than one radius apart, the first may end up in cell k and the second in cell k + 2.
TEMPLATE_LIST_TEST_CASE("a cell list does not lose a pair to the rounding of cell coordinates", "", Policies) {
  using P = TestType;
  using real = typename P::real;
  double const radius = 0.1, origin = 300;
  int lost = 0;
  for (int trial = 0; trial < 100; ++trial) {
    // The second particle is close to an edge of a cell, the first as far to its left as the loop still accepts as a
    // neighbour.
    real const right = real(radius * (trial + 2) + (double(trial % 21) - 10) * ulps<P>(origin) / 10 - 0.03);
    real left = real(right - radius * (1 + ulps<P>(2)));
    while (!(sq(right - left) < sq(real(radius)))) left = std::nextafter(left, right);
    Points<P::dim> points(3, Vec<P::dim, double>::Zero());
    points[0][0] = -origin - 0.03;
    points[1][0] = double(left);
    points[2][0] = double(right);
    auto const x = positions_of<P>(points);
    CellList<P> search(radius);
    search.update(x, x);
    lost += fault_of_candidates<P>(candidates<P>(search, x), values_of(x), values_of(x), radius) != "";
  }
  CHECK(lost == 0);
}

}  // namespace scree::test::cell_list_tests
