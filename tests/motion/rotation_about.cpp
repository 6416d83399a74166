// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/motion/rotation.hpp>
#include <scree/motion/rotation_about.hpp>

#include "kinematics.hpp"

#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>

namespace scree::test::rotation_about_tests {

using V = Vec<3, double>;

TEST_CASE("a rotation about any axis is consistent, and leaves its axis where it is") {
  RotationAbout const turn(0.7, {1, -2, 0.5}, {0.1, 0.2, -0.3});
  check_kinematics<3>(turn, {0.0, 0.4, 2.0});
  V const on_axis = V(0.1, 0.2, -0.3) + 0.8 * V(1, -2, 0.5);
  CHECK((turn.displaced(on_axis, 0.0, 3.1) - on_axis).norm() < 1e-15);
  CHECK(turn.velocity(on_axis, 0).norm() < 1e-15);
  // A third of a turn about the diagonal exchanges the axes: x becomes y.
  double const third = 2 * 3.14159265358979323846 / 3;
  CHECK((RotationAbout(1, {1, 1, 1}).displaced(V(1, 0, 0), 0.0, third) - V(0, 1, 0)).norm() < 1e-15);
}

TEST_CASE("about the second axis, backwards, it is the plane rotation") {
  Rotation const plane{.rate = 1.3, .centre_x = 0.4, .centre_z = -0.2};
  RotationAbout const turn(-1.3, {0, 3, 0}, {0.4, 9, -0.2});
  V const x(1, 2, 3);
  CHECK((turn.displaced(x, 0.2, 1.7) - plane.displaced(x, 0.2, 1.7)).norm() < 1e-14);
  CHECK((turn.velocity(x, 0) - plane.velocity(x, 0)).norm() < 1e-14);
  CHECK((turn.acceleration(x, 0) - plane.acceleration(x, 0)).norm() < 1e-14);
  CHECK(std::abs(turn.time_step() - plane.time_step()) < 1e-15);
  CHECK(std::isinf(RotationAbout().time_step()));
}

TEST_CASE("a rotation about an axis is the same from its parameters") {
  RotationAbout const turn(0.7, {1, -2, 0.5}, {0.1, 0.2, -0.3}, 0.02);
  RotationAbout const same({.rate = 0.7, .axis = {1, -2, 0.5}, .centre = {0.1, 0.2, -0.3}, .angle_per_step = 0.02});
  V const x(1, 2, 3);
  CHECK(turn.displaced(x, 0.2, 1.7) == same.displaced(x, 0.2, 1.7));
  CHECK(turn.time_step() == same.time_step());
}

TEST_CASE("a rotation about no axis is refused") {
  using Catch::Matchers::ContainsSubstring;
  CHECK_THROWS_WITH(RotationAbout(1, {0, 0, 0}),
                    ContainsSubstring("length of the axis of RotationAbout must be above 0, not 0"));
  CHECK_THROWS_WITH(RotationAbout(std::nan(""), {0, 0, 1}), ContainsSubstring("rate (rad/s) of RotationAbout"));
  CHECK_THROWS_WITH(RotationAbout(1, {0, 0, 1}, {0, std::nan(""), 0}),
                    ContainsSubstring("centre (m) of RotationAbout"));
}

}  // namespace scree::test::rotation_about_tests
