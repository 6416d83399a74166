// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/shapes/boolean.hpp>

#include "samples.hpp"

namespace scree::test::boolean_tests {

static_assert(Shape<Box<3>> && Shape<Cylinder> && Shape<decltype((disc & below) | complement(sheet))>);
static_assert(!Shape<int> && !ShapesOfOneSpace<Ball<2>, Ball<3>>);

TEST_CASE("signed distances of combinations are as good as promised") {
  using X = Vec<2, double>;
  check_distances(
      sheet | disc, [](X const& x) { return in_sheet(x) || in_disc(x); }, Exact::outside);
  check_distances(
      sheet & below, [](X const& x) { return in_sheet(x) && in_below(x); }, Exact::inside);
  check_distances(
      sheet - disc, [](X const& x) { return in_sheet(x) && !in_disc(x); }, Exact::inside);
  check_distances(
      complement(sheet), [](X const& x) { return !in_sheet(x); }, Exact::everywhere);
  check_distances(
      offset(disc, -0.3), [](X const& x) { return sq(x[0] - 0.3) + sq(x[1] + 0.1) < 0.25; }, Exact::everywhere);
  check_distances(
      offset(sheet, -0.2), [](X const& x) { return sheet.signed_distance(x) < -0.2; }, Exact::inside);
}

TEST_CASE("combinations obey the laws of De Morgan") {
  auto const x_of = [](auto const& shape, auto const& x) {
    return std::pair(shape.contains(x), shape.signed_distance(x));
  };
  for (auto const& x : probes<2>()) {
    CHECK(x_of(complement(sheet | disc), x) == x_of(complement(sheet) & complement(disc), x));
    CHECK(x_of(complement(sheet & disc), x) == x_of(complement(sheet) | complement(disc), x));
    CHECK(x_of(sheet - disc, x) == x_of(sheet & complement(disc), x));
    CHECK(x_of(complement(sheet - disc), x) == x_of(complement(sheet) | disc, x));
    CHECK(x_of((sheet | disc) & below, x) == x_of((sheet & below) | (disc & below), x));
    CHECK((unite(sheet, disc).contains(x) == (in_sheet(x) || in_disc(x))));
  }
}

}  // namespace scree::test::boolean_tests
