// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/motion/translation.hpp>

#include "kinematics.hpp"

#include <cmath>

namespace scree::test::translation_tests {

TEST_CASE("a translation moves all points alike, with a speed that may grow") {
  check_kinematics<2>(Translation<2>{.speed = {0.3, -0.1}}, {0.0, 3.0});  // `{}` would leave the growth unset
  check_kinematics<3>(Translation<3>{{0.3, -0.1, 0.2}, {0, 0.5, -0.25}}, {0.0, 3.0});
  Translation<2> const falling{{1, 0}, {0, -10}};
  CHECK(falling.displaced(Vec<2, double>(0, 0), 1.0, 3.0) == Vec<2, double>(2, -40));
  CHECK(falling.velocity(Vec<2, double>(5, 5), 2.0) == Vec<2, double>(1, -20));
  CHECK(std::isinf(falling.time_step()));
}

}  // namespace scree::test::translation_tests
