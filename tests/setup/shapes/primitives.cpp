// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/shapes/primitives.hpp>

#include "samples.hpp"

namespace scree::test::primitives_tests {

TEST_CASE("signed distances of shapes in a plane are those of many samples") {
  check_distances(sheet, in_sheet, Exact::everywhere);
  check_distances(disc, in_disc, Exact::everywhere);
  check_distances(below, in_below, Exact::everywhere);
}

TEST_CASE("signed distances of shapes in space are those of many samples") {
  using X = Vec<3, double>;
  check_distances(
      block, [](X const& x) { return ((x.array() > block.low.array()) && (x.array() < block.high.array())).all(); },
      Exact::everywhere);
  check_distances(
      sphere, [](X const& x) { return sq(x[0] - 0.3) + sq(x[1] + 0.1) + sq(x[2] - 0.2) < 0.64; }, Exact::everywhere);
  check_distances(
      drum, [](X const& x) { return x[1] > -0.6 && x[1] < 0.4 && sq(x[0] - 0.2) + sq(x[2] + 0.1) < 0.49; },
      Exact::everywhere);
}

TEST_CASE("cylinders may lie along any axis") {
  Cylinder const along_x{.axis = 0, .centre = {0, 1, 2}, .radius = 0.5, .from = -1, .to = 3};
  CHECK(std::abs(along_x.signed_distance({1, 1, 2.3}) + 0.2) < 1e-15);
  CHECK(std::abs(along_x.signed_distance({6, 1.5 + 4, 2}) - 5) < 1e-15);
  Cylinder const upright{.axis = 2, .centre = {0, 1, 2}, .radius = 0.5, .from = -1, .to = 3};
  CHECK(std::abs(upright.signed_distance({0.1, 1, 2.7}) + 0.3) < 1e-15);
  CHECK(upright.bounds().low == Vec<3, double>(-0.5, 0.5, -1));
  CHECK(upright.bounds().high == Vec<3, double>(0.5, 1.5, 3));
}

}  // namespace scree::test::primitives_tests
