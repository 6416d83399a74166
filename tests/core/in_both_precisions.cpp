// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/core/in_both_precisions.hpp>

#include <catch2/catch_test_macros.hpp>

namespace scree::test::in_both_precisions_tests {

TEST_CASE("a constant in both precisions is exact in double and rounded once in float, for packs as for numbers") {
  double const tenth = 0.1, third = 1.0 / 3;
  InBothPrecisions<3> constants(Vec<3, double>(tenth, 2, -1));
  constants.set(2, third);
  CHECK(constants.of<double>(0) == tenth);
  CHECK(constants.of<float>(0) == float(tenth));
  CHECK(constants.of<double>(2) == third);
  CHECK(constants.of<float>(2) == float(third));
  STATIC_CHECK(std::is_same_v<decltype(constants.of<float>(0)), float>);
#ifdef SCREE_HAS_PACKS
  STATIC_CHECK(std::is_same_v<decltype(constants.of<Pack<float>>(0)), float>);
  CHECK(constants.of<Pack<double>>(2) == third);
#endif
  CHECK(InBothPrecisions<2>().of<double>(1) == 0);
}

}  // namespace scree::test::in_both_precisions_tests
