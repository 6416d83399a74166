// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/motion/delayed.hpp>
#include <scree/motion/oscillation.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/motion/translation.hpp>

#include "kinematics.hpp"

#include <cmath>

namespace scree::test::delayed_tests {
namespace {
using V = Vec<2, double>;
V const x(0.3, 0.7);
}  // namespace

TEST_CASE("a delayed motion is at rest before its start and after its stop, and moves between them") {
  Delayed<Translation<2>> const lift{.motion = {.speed = {0, 2}}, .start = 0.1, .stop = 0.4};
  for (double const t : {0.0, 0.05, 0.0999, 0.4, 7.0}) {
    CHECK(lift.velocity(x, t) == V(0, 0));
    CHECK(lift.acceleration(x, t) == V(0, 0));
  }
  CHECK(lift.velocity(x, 0.1) == V(0, 2));
  CHECK(lift.displaced(x, 0, 0.1) == x);
  CHECK((lift.displaced(x, 0, 0.3) - V(0.3, 1.1)).norm() < 1e-15);
  CHECK((lift.displaced(x, 0, 9) - V(0.3, 1.3)).norm() < 1e-15);
  CHECK((lift.displaced(lift.displaced(x, 0, 0.2), 0.2, 9) - V(0.3, 1.3)).norm() < 1e-15);
  CHECK(lift.displaced(x, 0.5, 9) == x);
}

TEST_CASE("the time of a delayed motion counts from its start") {
  check_kinematics<2>(Delayed<Rotation>{{.rate = 2, .centre_x = 1}, 0.1}, {0.05, 0.2, 1.2});
  Oscillation<2> const swing{.amplitude = {1, 0}, .period = 4};
  Delayed<Oscillation<2>> const later{swing, 0.5};
  CHECK(later.velocity(x, 1.2) == swing.velocity(x, 1.2 - 0.5));
  CHECK(later.acceleration(x, 1.2) == swing.acceleration(x, 1.2 - 0.5));
  CHECK(later.time_step() == swing.time_step());
}

TEST_CASE("a delayed motion gives a velocity gradient if its motion does") {
  struct WithGradient : Rotation {
    Mat<2, double> velocity_gradient(V const&, double time) const { return Mat<2, double>::Constant(time); }
  };
  STATIC_CHECK_FALSE(GivesVelocityGradient<Delayed<Rotation>, 2, double>);
  STATIC_CHECK(GivesVelocityGradient<Delayed<WithGradient>, 2, double>);
  Delayed<WithGradient> const later{{}, 0.25};
  CHECK(later.velocity_gradient(x, 1)(0, 0) == 0.75);
  CHECK(later.velocity_gradient(x, 0.2)(0, 0) == 0);
}

}  // namespace scree::test::delayed_tests
