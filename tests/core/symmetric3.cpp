// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/core/symmetric3.hpp>

#include <catch2/catch_test_macros.hpp>

#include <limits>

namespace scree::test::symmetric3_tests {

TEST_CASE("symmetric3: entries of a tensor in space, and only its upper triangle is read") {
  Mat<3, double> full;
  full << 1, 4, 5, 4, 2, 6, 5, 6, 3;
  Mat<3, double> upper = full;
  upper(1, 0) = upper(2, 0) = upper(2, 1) = std::numeric_limits<double>::quiet_NaN();
  Vec<6, double> expected;
  expected << 1, 2, 3, 4, 5, 6;
  CHECK(packed<3>(full) == expected);
  CHECK(packed<3>(upper) == expected);
  CHECK(unpacked(expected) == full);
  CHECK(product(expected, Vec<3, double>(7, -8, 9)) == Vec<3, double>(full * Vec<3, double>(7, -8, 9)));
}

TEST_CASE("symmetric3: plane strain keeps the entry out of the plane and couples it to nothing") {
  Mat<3, float> full;
  full << 1, 4, 0, 4, 2, 0, 0, 0, 3;
  Vec<4, float> const expected(1, 2, 3, 4);
  CHECK(packed<2>(full) == expected);
  CHECK(unpacked(expected) == full);
  CHECK(product(expected, Vec<2, float>(7, -8)) == Vec<2, float>(-25, 12));
}

TEST_CASE("symmetric3: an expression of packed tensors unpacks like its value") {
  Vec<4, double> const a(1, 2, 3, 4), b(5, 6, 7, 8);
  CHECK(unpacked(a + 2 * b) == unpacked(Vec<4, double>(11, 14, 17, 20)));
}

TEST_CASE("symmetric3: a gradient of the plane changes nothing out of it") {
  Mat<2, double> L;
  L << 1, 2, 3, 4;
  Mat<3, double> expected;
  expected << 1, 2, 0, 3, 4, 0, 0, 0, 0;
  CHECK(in_three_dimensions(L) == expected);
  CHECK(in_three_dimensions(expected) == expected);
}

TEST_CASE("symmetric3: the layout of packed tensors does not depend on compiler flags") {
  STATIC_CHECK(symmetric3_size<2> == 4);
  STATIC_CHECK(symmetric3_size<3> == 6);
  STATIC_CHECK(alignof(Vec<4, double>) == alignof(double));
  STATIC_CHECK(sizeof(Vec<6, float>) == 6 * sizeof(float));
}

}  // namespace scree::test::symmetric3_tests
