// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/motion/oscillation.hpp>

#include "kinematics.hpp"

#include <cmath>

namespace scree::test::oscillation_tests {

TEST_CASE("an oscillation swings along its amplitude") {
  check_kinematics<2>(Oscillation<2>{.amplitude = {0.2, 0.1}, .period = 4}, {0.0, 0.7, 3.1});
  Oscillation<3> const from_rest{.amplitude = {0, 0.5, 0.1}, .period = 4, .phase = 1.57079632679489662};
  check_kinematics<3>(from_rest, {0.0, 0.7, 3.1});
  Vec<3, double> const x(1, 2, 3);
  CHECK(from_rest.velocity(x, 0.0).norm() < 1e-15);
  CHECK((from_rest.displaced(x, 0.0, 2.0) - Vec<3, double>(1, 1, 2.8)).norm() < 1e-15);
  CHECK((from_rest.displaced(x, 0.3, 4.3) - x).norm() < 1e-15);
}

TEST_CASE("a step of an oscillation goes on by no more than the angle asked for") {
  CHECK(std::abs(Oscillation<2>{.amplitude = {1, 0}, .period = 6.28318530717958648}.time_step() - 0.05) < 1e-15);
  CHECK(std::isinf(Oscillation<2>{}.time_step()));
}

}  // namespace scree::test::oscillation_tests
