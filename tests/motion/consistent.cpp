// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/motion/any_motion.hpp>
#include <scree/motion/composed.hpp>
#include <scree/motion/delayed.hpp>
#include <scree/motion/oscillating_shear.hpp>
#include <scree/motion/oscillation.hpp>
#include <scree/motion/prescribe.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/motion/rotation_about.hpp>
#include <scree/motion/tabulated.hpp>
#include <scree/motion/translation.hpp>

#include <motion/kinematics.hpp>

#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <limits>

namespace scree::test::consistent_tests {
namespace {

using Catch::Matchers::ContainsSubstring;

template <int Dim, class Motion>
void compare(Motion const& motion, double from, double to) {
  detail::check_path(detail::path_of<Motion, Dim>(motion, some_point<Dim>(), true), from, to);
}
/// Windows of all lengths, also around starts, stops and points of tables at whole and half seconds.
template <int Dim, class Motion>
void check_agrees(Motion const& motion) {
  for (double const length : {1e-6, 1e-4, 1e-2, 0.3, 3.0})
    for (double const at : {0.0, 0.1, 0.5, 1.0, 2.0, 3.0, 17.3, 1e4})
      for (double const before : {0.0, 0.01, 0.3, 0.499, 0.5, 0.999, 1.0}) {
        double const from = at - before * length;
        INFO("from " << from << " s, " << length << " s long");
        if (from >= 0) CHECK_NOTHROW(compare<Dim>(motion, from, from + length));
      }
}
/// Moves with one speed along the first axis, and tells others; jumps at a time.
struct Told {
  double speed = 0, told_speed = 0, acceleration = 0, told_acceleration = 0, jump = 0, jumps_at = 0.5;
  double way(double t) const { return speed * t + acceleration * t * t / 2 + (t > jumps_at ? jump : 0); }
  template <class X>
  X displaced(X const& x, double from, double to) const {
    return x + X(X::Unit(0) * (way(to) - way(from)));
  }
  template <class X>
  X velocity(X const&, double t) const {
    return X::Unit(0) * (told_speed + acceleration * t);
  }
};
struct Own : Told {
  explicit Own(Told const& told) : Told(told) {}
  template <class X>
  X acceleration(X const&, double) const {
    return X::Unit(0) * told_acceleration;
  }
};
/// Speeds up from rest; the displacement is that from rest, whatever the time is.
struct FromRest {
  double a = 3;
  template <class X>
  X displaced(X const& x, double from, double to) const {
    return x + X(X::Unit(0) * (a / 2 * (to - from) * (to - from)));
  }
  template <class X>
  X velocity(X const&, double t) const {
    return X::Unit(0) * (a * t);
  }
  template <class X>
  X acceleration(X const&, double) const {
    return X::Unit(0) * a;
  }
};
void compare_told(Told const& told, double from = 0, double to = 1e-3) { compare<2>(Own(told), from, to); }

}  // namespace

TEST_CASE("the functions of each motion of the library agree, also around starts, stops and points of tables") {
  check_agrees<2>(Rotation{.rate = 3, .centre_x = 0.2, .centre_z = -0.4});
  check_agrees<3>(Rotation{.rate = -30});
  check_agrees<3>(RotationAbout(5, {1, 2, 3}, {0.1, 0, 0}));
  check_agrees<2>(Translation<2>{.speed = {0.3, -2}, .growth = {0.1, 1}});
  check_agrees<2>(Oscillation<2>{.amplitude = {0.1, 0}, .period = 0.14});
  check_agrees<2>(OscillatingShear{.amplitude = 0.5, .period = 0.7});
  check_agrees<2>(Tabulated<2>({0, 0.5, 1, 2}, {{0, 0}, {0.1, 0}, {0.1, 0.3}, {0, 0}}));
  check_agrees<2>(Tabulated<2>({0, 0.5, 1, 2, 100}, {{0, 0}, {0, 0}, {1, 1}, {1, 1}, {1, 1}}));
  check_agrees<2>(Delayed<Rotation>{{.rate = 3}, 0.5, 2});
  check_agrees<2>(Delayed<Translation<2>>{{.speed = {1, 0}}, 1, 3});
  check_agrees<3>(Composed<Rotation, Rotation>{{.rate = 2}, {.rate = -5, .centre_x = 0.3}});
  check_agrees<2>(AnyMotion<Rotation, Delayed<Rotation>>(Delayed<Rotation>{{.rate = -1}, 1}));
  check_agrees<2>(AtRest{});
}

TEST_CASE("motions whose functions contradict each other are refused, with what they say") {
  CHECK_NOTHROW(compare_told({.speed = 0.5, .told_speed = 0.5}));
  CHECK_NOTHROW(compare_told({.speed = 0.5, .told_speed = 0.502}));
  CHECK_NOTHROW(compare_told({.acceleration = 100, .told_acceleration = 100.4}));
  CHECK_THROWS_WITH(compare_told({.speed = 0.5}),
                    ContainsSubstring("scree: the motion contradicts itself from 0 to 0.001 s: `displaced` carries the "
                                      "point at (1.2, 0.8, 0) m by (0.0005, 0, 0) m, and `velocity` by (0, 0, 0) m"));
  CHECK_THROWS_WITH(compare_told({.told_speed = 0.5}), ContainsSubstring("by (0, 0, 0) m, and `velocity` by (0.0005"));
  CHECK_THROWS_WITH(compare_told({.speed = 0.5, .told_speed = 0.51}), ContainsSubstring("`displaced`"));
  CHECK_THROWS_WITH(compare_told({.speed = 0.5, .told_speed = -0.5}), ContainsSubstring("`displaced`"));
  CHECK_THROWS_WITH(compare_told({.speed = 1e-6}), ContainsSubstring("`displaced`"));
  CHECK_THROWS_WITH(compare_told({.told_acceleration = 1000}),
                    ContainsSubstring("`velocity` of the point at (1.2, 0.8, 0) m changes by (0, 0, 0) m/s, and "
                                      "`acceleration` changes it by (1, 0, 0) m/s"));
  CHECK_THROWS_WITH(compare_told({.acceleration = 10}), ContainsSubstring("`acceleration` changes it by (0, 0, 0)"));
  CHECK_THROWS_WITH(compare_told({.acceleration = 10, .told_acceleration = 10.3}), ContainsSubstring("`acceleration`"));
  for (double const jump : {100.0, 0.05, 1e-6})
    for (double const speed : {0.0, 0.3}) {
      Told const jumping{.speed = speed, .told_speed = speed, .jump = jump};
      CHECK_NOTHROW(compare_told(jumping, 0, 0.5));
      if (jump > 0.01 * speed * 1e-3) CHECK_THROWS_WITH(compare_told(jumping, 0.4995, 0.5005), ContainsSubstring("by"));
    }
}

TEST_CASE("a displacement that follows from the length of the time only is refused where the motion speeds up") {
  CHECK_NOTHROW(compare<2>(FromRest(), 0, 1e-3));
  for (double const from : {1e-3, 0.1, 5.0})
    CHECK_THROWS_WITH(compare<2>(FromRest(), from, from + 1e-3),
                      ContainsSubstring("`displaced(x, from, to)` carries the point at x = ("));
  CHECK_NOTHROW(compare<3>(FromRest{0}, 1, 2));
}

TEST_CASE("values of a motion that are not finite are left to other checks") {
  double const none = std::numeric_limits<double>::quiet_NaN();
  CHECK_NOTHROW(compare_told({.speed = none, .told_speed = 1}));
  CHECK_NOTHROW(compare_told({.told_speed = none}));
}

}  // namespace scree::test::consistent_tests
