// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/granular.hpp>
#include <scree/motion/delayed.hpp>
#include <scree/motion/motion_of_groups.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/motion/translation.hpp>
#include <scree/solver/slip.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <limits>

namespace scree::test::slip_tests {
using namespace fields;
namespace {
using Catch::Matchers::ContainsSubstring;
using Q = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
using InSpace = Policy<3, float, Kokkos::DefaultHostExecutionSpace>;
using V = Vec<2, double>;

template <class P>
Solver<P> beside(Groups<P::dim> const& walls, typename P::motion const& motion = {}) {
  return Solver<P>({.spacing = 0.1, .motion = motion}, {}, walls);
}
template <class Motion = AtRest>
using Sand = Formulated<Q, Granular<>, Motion>;

Groups<2> box() { return Groups<2>().add("floor", {V(0, -0.1), V(0.1, -0.1)}).add("side", {V(-0.1, 0), V(-0.1, 0.1)}); }

}  // namespace

TEST_CASE("one group of a wall slips, and all others stick") {
  auto const walls = box();
  auto solver = beside<Sand<>>(walls);
  set_slip(solver, walls, "side", V(-3, 0));
  CHECK(solver.wall().to_host(slip_normal) == std::vector<V>{{0, 0}, {0, 0}, {-1, 0}, {-1, 0}});
  set_slip(solver, walls, "floor", [](V const& x) { return V(x[0], x[0]); });
  auto const n = solver.wall().to_host(slip_normal);
  CHECK(n[0] == V(0, 0));  // a zero vector: the particle sticks
  CHECK((n[1] - V(std::sqrt(0.5), std::sqrt(0.5))).norm() < 1e-15);
  CHECK(n[3] == V(-1, 0));
  set_slip(solver, walls, "side", V(0, 0));
  CHECK(solver.wall().to_host(slip_normal)[3] == V(0, 0));
}

TEST_CASE("slip normals are set in space and in single precision") {
  using X = Vec<3, double>;
  auto const walls = Groups<3>().add("a", {X(0, 0, 0)}).add("b", {X(1, 0, 0), X(1, 2, 0)});
  auto solver = beside<Formulated<InSpace, Granular<>>>(walls);
  set_slip(solver, walls, "b", [](Vec<3, float> const& x) { return Vec<3, float>(0, x[1], 2); });
  auto const n = solver.wall().to_host(slip_normal);
  CHECK(n[0].norm() == 0);
  CHECK(n[1] == Vec<3, float>(0, 0, 1));
  CHECK((n[2] - Vec<3, float>(0, std::sqrt(0.5f), std::sqrt(0.5f))).norm() < 1e-7f);
}

TEST_CASE("bad slip normals and groups are refused, and nothing changes") {
  auto const walls = box();
  auto solver = beside<Sand<>>(walls);
  double const nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(set_slip(solver, walls, "lid", V(0, 1)), ContainsSubstring("no group 'lid'"));
  CHECK_THROWS_WITH(set_slip(solver, walls, "side", V(0, nan)), ContainsSubstring("neither length 0 nor length 1"));
  CHECK_THROWS_WITH(set_slip(solver, Groups<2>().add("side", {V(0, 0)}), "side", V(0, 1)),
                    ContainsSubstring("these groups have 1 particles, and the body has 4"));
  CHECK(solver.wall().to_host(slip_normal) == std::vector<V>(4, V(0, 0)));
}

TEST_CASE("a wall that its motion turns cannot slip, but one that moves straight can") {
  using Motion = MotionOfGroups<2, Rotation, Delayed<Rotation>, Translation<2>>;
  auto const walls = box();
  Motion motion(walls);
  motion.set(walls.number("floor"), Delayed<Rotation>{.motion = {.rate = 1}, .start = 5});
  motion.set(walls.number("side"), Translation<2>{.speed = {1, 2}});
  auto solver = beside<Sand<Motion>>(walls, motion);
  CHECK_NOTHROW(set_slip(solver, walls, "side", V(1, 0)));
  CHECK_THROWS_WITH(set_slip(solver, walls, "floor", V(0, 1)), ContainsSubstring("the motion turns this wall"));
  auto turning = beside<Sand<Rotation>>(walls, Rotation{.rate = 0.1});
  CHECK_THROWS_WITH(set_slip(turning, walls, "side", V(1, 0)), ContainsSubstring("the motion turns this wall"));
  // The ends of a drum turn in their own plane.
  using X = Vec<3, double>;
  auto const ends = Groups<3>().add("end", {X(0.3, 0, 0.1)});
  auto drum = beside<Formulated<InSpace, Granular<>, Rotation>>(ends, Rotation{.rate = 2});
  CHECK_NOTHROW(set_slip(drum, ends, "end", X(0, 1, 0)));
  CHECK_THROWS_WITH(set_slip(drum, ends, "end", X(0, 1, 1)), ContainsSubstring("the motion turns this wall"));
}

TEST_CASE("normals set by hand must be unit vectors of walls that their motion does not turn") {
  auto const set = [](auto solver, V const& n) { solver.template set<Wall>(slip_normal, [&](V const&) { return n; }); };
  Groups<2> const walls = box();
  CHECK_NOTHROW(set(beside<Sand<>>(walls), V(0, 1)));
  CHECK_THROWS_WITH(set(beside<Sand<>>(walls), V(0, 2)),
                    "scree: the wall particle that starts at (0, ..., -0.1) m cannot slip: its slip normal has neither "
                    "length 0 nor length 1");
  CHECK_THROWS_WITH(set(beside<Sand<Rotation>>(walls, Rotation{.rate = 0.1}), V(0, 1)),
                    ContainsSubstring("the motion turns this wall"));
  CHECK_NOTHROW(set(beside<Sand<Rotation>>(walls, Rotation{.rate = 0.1}), V(0, 0)));
}

}  // namespace scree::test::slip_tests
