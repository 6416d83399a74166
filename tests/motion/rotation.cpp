// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/motion/rotation.hpp>

#include "kinematics.hpp"

#include <cmath>

namespace scree::test::rotation_tests {

TEST_CASE("a rotation turns about its centre from the first towards the last axis") {
  Rotation const turn{.rate = 0.7, .centre_x = 1, .centre_z = -0.5};
  check_kinematics<2>(turn, {0.0, 0.4, 2.0});
  check_kinematics<3>(turn, {0.4});
  double const quarter = 1.57079632679489662 / 0.7;
  Vec<3, double> const at = turn.displaced(Vec<3, double>(3, 7, -0.5), 0.0, quarter);
  CHECK((at - Vec<3, double>(1, 7, 1.5)).norm() < 1e-15);
  CHECK(turn.velocity(Vec<2, double>(1, -0.5), 0) == Vec<2, double>(0, 0));
  CHECK(std::abs(turn.velocity(Vec<3, double>(1, 9, 1.5), 0)[0] + 1.4) < 1e-15);
  CHECK(turn.acceleration(Vec<3, double>(1, 9, -0.5), 0) == Vec<3, double>(0, 0, 0));
}

TEST_CASE("a step of a rotation turns by no more than asked for") {
  CHECK(std::abs(Rotation{.rate = -2}.time_step() - 0.025) < 1e-15);
  CHECK(std::isinf(Rotation{}.time_step()));
}

}  // namespace scree::test::rotation_tests
