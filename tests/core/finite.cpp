// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/core/finite.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <limits>

namespace scree::test::finite_tests {

TEMPLATE_TEST_CASE("a value is finite if all its numbers are", "", float, double) {
  auto const infinity = std::numeric_limits<TestType>::infinity(), nan = std::numeric_limits<TestType>::quiet_NaN();
  CHECK(detail::is_finite(TestType(3)));
  CHECK(detail::is_finite(std::numeric_limits<TestType>::max()));
  CHECK(detail::is_finite(7));
  Mat<3, TestType> const unit = Mat<3, TestType>::Identity();
  CHECK(detail::is_finite(unit));
  for (TestType const bad : {nan, infinity, -infinity}) {
    CHECK_FALSE(detail::is_finite(bad));
    for (int k = 0; k < 9; ++k) {
      Mat<3, TestType> spoilt = unit;
      spoilt.data()[k] = bad;
      CHECK_FALSE(detail::is_finite(spoilt));
    }
  }
}

}  // namespace scree::test::finite_tests
