// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/motion/composed.hpp>
#include <scree/motion/oscillation.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/motion/rotation_about.hpp>
#include <scree/motion/translation.hpp>

#include "kinematics.hpp"

#include <cmath>
#include <stdexcept>

namespace scree::test::composed_tests {

using V = Vec<3, double>;

TEST_CASE("a composed motion is consistent, also of nested and of unsteady ones") {
  RotationAbout const around(0.5, {0, 0, 1}), blade(1.7, {0.2, 0, 1}, {0.4, 0.1, 0});
  Composed<RotationAbout, RotationAbout> const mixer{around, blade};
  check_kinematics<3>(mixer, {0.0, 0.4, 2.0});
  check_kinematics<3>(Composed<Translation<3>, decltype(mixer)>{{.speed = {0.1, 0, 0.3}}, mixer}, {0.4, 2.0});
  Oscillation<3> const shake{.amplitude = {0.1, 0.2, 0}, .period = 4};
  check_kinematics<3>(Composed<RotationAbout, Oscillation<3>>{around, shake}, {0.4, 2.0});
  check_kinematics<3>(Composed<Oscillation<3>, RotationAbout>{shake, blade}, {0.4, 2.0});
  check_kinematics<2>(Composed<Rotation, Translation<2>>{{.rate = 0.7}, {.speed = {0.2, 0.1}}}, {0.4, 2.0});
}

TEST_CASE("the axis of the inner rotation of a mixer goes around with the outer one") {
  double const pi = 3.14159265358979323846;
  V const axis(0.4, 0, 0);
  Composed<RotationAbout, RotationAbout> const mixer{{1, {0, 0, 1}}, {3, {0, 0, 1}, axis}};
  CHECK((mixer.displaced(axis, 0.0, pi / 2) - V(0, 0.4, 0)).norm() < 1e-15);
  // A tip 0.1 beyond the axis has turned by 90 + 270 degrees, so it points along x again.
  V const tip = mixer.displaced(V(0.5, 0, 0), 0.0, pi / 2);
  CHECK((tip - V(0.1, 0.4, 0)).norm() < 1e-15);
  // Its velocity is 1 x 0.4 against x and (1 + 3) x 0.1 along y; its acceleration 0.4 against y and 16 x 0.1 against x.
  CHECK((mixer.velocity(tip, pi / 2) - V(-0.4, 0.4, 0)).norm() < 1e-14);
  CHECK((mixer.acceleration(tip, pi / 2) - V(-1.6, -0.4, 0)).norm() < 1e-14);
  CHECK(std::abs(mixer.time_step() - 0.05 / 3) < 1e-15);
}

TEST_CASE("the parts of a composed motion are checked") {
  CHECK_NOTHROW((Composed<Rotation, Translation<2>>{}.check()));
  CHECK_THROWS_AS((Composed<Rotation, Translation<2>>{{.angle_per_step = 0}, {}}.check()), std::invalid_argument);
  CHECK_THROWS_AS((Composed<Translation<2>, Rotation>{{}, {.angle_per_step = 0}}.check()), std::invalid_argument);
}

TEST_CASE("the velocity of a composed motion is affine, so that walls may follow it") {
  Composed<RotationAbout, RotationAbout> const mixer{{1, {0, 1, 1}}, {3, {0, 0, 1}, {0.4, 0, 0}}};
  auto const L = velocity_gradient_at(mixer, V(0.3, 0.2, 0.1), 0.7);
  CHECK((L + L.transpose()).norm() < 1e-14);  // a rigid motion
  V const d(0.3, -2, 1);
  CHECK((mixer.velocity(V(V(0.3, 0.2, 0.1) + d), 0.7) - mixer.velocity(V(0.3, 0.2, 0.1), 0.7) - L * d).norm() < 1e-14);
}

}  // namespace scree::test::composed_tests
