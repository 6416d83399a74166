// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/motion/motion_of_groups.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/motion/translation.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>

namespace scree::test::motion_of_groups_tests {
namespace {
using Catch::Matchers::ContainsSubstring;
using V = Vec<2, double>;
using Motion = MotionOfGroups<3, Rotation, Translation<2>>;
}  // namespace

TEST_CASE("each group has its own motion, and rests if it got none") {
  STATIC_CHECK(MotionByGroup<Motion>);
  STATIC_CHECK(PrescribedMotion<Motion, 2, float>);
  STATIC_CHECK_FALSE(MotionOfPoints<Motion, 2, float>);
  auto const walls = Groups<2>().add("vessel", {V(0, 0)}).add("blade", {}).add("lid", {V(1, 1)});
  Motion motion(walls);
  motion.set(walls.number("blade"), Rotation{.rate = -2}).set(0, Translation<2>{.speed = {1, 2}});
  V const x(0.5, 0.25);
  CHECK(motion.of(0).velocity(x, 0) == V(1, 2));
  CHECK(motion.of(1).velocity(x, 0) == Rotation{.rate = -2}.velocity(x, 0));
  CHECK(motion.of(2).velocity(x, 0) == V(0, 0));
  CHECK(motion.of(2).displaced(x, 0, 9) == x);
  CHECK(motion.groups() == 3);
}

TEST_CASE("the shortest step of all groups counts") {
  Motion motion(2);
  CHECK(std::isinf(motion.time_step()));
  motion.set(0, Rotation{.rate = -2}).set(1, Rotation{.rate = 5});
  CHECK(motion.time_step() == Rotation{.rate = 5}.time_step());
}

TEST_CASE("the motion of particles is that of their group") {
  struct Particle {
    int number;
    int operator[](Group) const { return number; }
  };
  Motion motion(2);
  motion.set(1, Rotation{.rate = 1});
  CHECK(motion_of(motion, Particle{1}).velocity(V(1, 0), 0) == V(0, 1));
  CHECK(motion_of(motion, Particle{0}).velocity(V(1, 0), 0) == V(0, 0));
  CHECK(motion_of(Rotation{.rate = 3}, Particle{0}).velocity(V(1, 0), 0) == V(0, 3));
  CHECK(motion_of_group(motion, 1).velocity(V(1, 0), 0) == V(0, 1));
}

TEST_CASE("motions of groups that do not exist are refused") {
  Motion motion(2);
  CHECK_THROWS_WITH(motion.set(2, Rotation{}), ContainsSubstring("no group 2: the motion is that of 2 groups"));
  CHECK_THROWS_WITH(motion.set(-1, Rotation{}), ContainsSubstring("no group -1"));
  CHECK_THROWS_WITH(Motion(4), ContainsSubstring("MotionOfGroups<3, ...>") && ContainsSubstring("not 4"));
  CHECK_THROWS_AS(Motion(-1), std::invalid_argument);
  CHECK_THROWS_WITH(Motion().set(0, Rotation{}), ContainsSubstring("of 0 groups"));
}

}  // namespace scree::test::motion_of_groups_tests
