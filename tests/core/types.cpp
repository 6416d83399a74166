// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/core/types.hpp>

#include <catch2/catch_test_macros.hpp>

namespace scree::test::types_tests {

TEST_CASE("powers are products") {
  STATIC_CHECK(sq(3) == 9);
  STATIC_CHECK(math::power<0>(3.0) == 1);
  STATIC_CHECK(math::power<1>(3.0) == 3);
  STATIC_CHECK(math::power<5>(2) == 32);
  STATIC_CHECK(math::power<8>(2) == 256);
  STATIC_CHECK(math::power<3>(-0.5f) == -0.125f);
}

TEST_CASE("zero is zero for numbers and small matrices") {
  CHECK(zero<float>() == 0);
  CHECK(zero<Vec<3, double>>() == Vec<3, double>(0, 0, 0));
  CHECK(zero<Mat<2, float>>().norm() == 0);
}

TEST_CASE("the layout of small vectors does not depend on compiler flags") {
  STATIC_CHECK(alignof(Vec<2, double>) == alignof(double));
  STATIC_CHECK(sizeof(Vec<3, float>) == 3 * sizeof(float));
  STATIC_CHECK(alignof(Mat<2, double>) == alignof(double));
}

TEST_CASE("a symmetric tensor has 3 or 6 entries") {
  STATIC_CHECK(symmetric_size<2> == 3);
  STATIC_CHECK(symmetric_size<3> == 6);
}

}  // namespace scree::test::types_tests
