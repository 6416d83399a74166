// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/shapes/shape.hpp>

#include "samples.hpp"

namespace scree::test::shape_tests {

TEST_CASE("bounds hold the shape and no more than they must") {
  double const infinity = std::numeric_limits<double>::infinity();
  CHECK(disc.bounds().low.isApprox(Vec<2, double>(-0.5, -0.9)));
  CHECK(disc.bounds().high.isApprox(Vec<2, double>(1.1, 0.7)));
  CHECK(drum.bounds().low.isApprox(Vec<3, double>(-0.5, -0.6, -0.8)));
  CHECK(drum.bounds().high.isApprox(Vec<3, double>(0.9, 0.4, 0.6)));
  CHECK((sheet | disc).bounds().low == Vec<2, double>(-0.8, -0.9));
  CHECK((sheet & disc).bounds().high.isApprox(Vec<2, double>(0.7, 0.7)));
  CHECK((sheet - disc).bounds().low == sheet.low);
  CHECK(offset(sheet, 0.1).bounds().high.isApprox(Vec<2, double>(0.8, 1)));
  CHECK(below.bounds().high[0] == infinity);
  CHECK(complement(disc).bounds().low[1] == -infinity);
  HalfSpace<2> const level{.point = {3, 0.25}, .normal = {0, 2}};
  CHECK(level.bounds().high == Vec<2, double>(infinity, 0.25));
  CHECK(level.bounds().low == Vec<2, double>(-infinity, -infinity));
  HalfSpace<2> const right{.point = {3, 0.25}, .normal = {-1, 0}};
  CHECK(right.bounds().low == Vec<2, double>(3, -infinity));
  // Shapes without a common point have bounds without extent.
  auto const none = (sheet & Ball<2>{.centre = {5, 0}, .radius = 1}).bounds();
  CHECK((none.high - none.low).minCoeff() == 0);
}

TEST_CASE("a box may be open to one side") {
  Box<2> const column{{0, 0}, {1, std::numeric_limits<double>::infinity()}};
  CHECK(column.contains({0.5, 1e6}));
  CHECK(column.signed_distance({0.4, 100}) == -0.4);
  CHECK(std::abs(column.signed_distance({-3, -4}) - 5) < 1e-15);
}

TEST_CASE("normals point outwards, of given and of computed gradients") {
  auto const close = [](auto const& a, auto const& b) { return (a - b).norm() < 1e-8; };
  using X = Vec<2, double>;
  CHECK(close(outward_normal(sheet, X(0.6, 0)), X(1, 0)));
  CHECK(close(outward_normal(sheet, X(0, -0.7)), X(0, -1)));
  CHECK(close(outward_normal(sheet, X(0.7 + 0.3, 0.9 + 0.4)), X(0.6, 0.8)));
  CHECK(close(outward_normal(below, X(0, 0)), X(-0.6, 1.6).normalized()));
  CHECK(close(outward_normal(sheet - disc, X(0.3 - 0.77, -0.1)), X(1, 0)));  // into the hole
  for (auto const& x : probes<2>()) {
    CHECK(close(outward_normal(disc, x), outward_normal(offset(disc, 0), x)));
    CHECK(close(outward_normal(below, x), -outward_normal(complement(below), x)));
  }
  CHECK(close(outward_normal(drum, Vec<3, double>(0.2, 0.3, 0)), Vec<3, double>(0, 1, 0)));
  CHECK(close(outward_normal(drum, Vec<3, double>(0.2 + 0.36, 0, -0.1 + 0.48)), Vec<3, double>(0.6, 0, 0.8)));
  CHECK(outward_normal(disc, disc.centre).norm() == 0);
  // Midway between two sides the gradient consists of rounding errors.
  for (double const y : {0.2, 0.1 + 0.2, 1.0 / 7, 1.1}) {
    Box<2> const bar{{-5, y - 0.7}, {5, y + 0.7}};
    for (double const x : {0.0, 0.3, 1.0 / 7}) CHECK(outward_normal(bar, X(x, y)).norm() == 0);
  }
}

TEST_CASE("a normal can be computed far from the origin") {
  Ball<2> const far{.centre = {1e4, 0}, .radius = 1};
  CHECK((outward_normal(offset(far, 0), Vec<2, double>(1e4 + 0.6, 0.8)) - Vec<2, double>(0.6, 0.8)).norm() < 1e-2);
}

}  // namespace scree::test::shape_tests
