// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/motion/tabulated.hpp>

#include "kinematics.hpp"

#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>

namespace scree::test {
namespace {
using V = Vec<2, double>;
V const origin(0, 0);
std::vector<double> const times{0.5, 1, 1.2, 2.5, 3};
std::vector<V> const places{{0, 0}, {0.1, 0.3}, {0.2, 0.3}, {-0.4, 0.1}, {-0.4, 0}};
}  // namespace

TEST_CASE("a tabulated motion passes through its table and has the derivatives of its path") {
  Tabulated<2> const motion(times, places);
  for (std::size_t k = 0; k < times.size(); ++k)
    CHECK((motion.displaced(origin, 0.0, times[k]) - places[k]).norm() < 1e-15);
  check_kinematics<2>(motion, {0.2, 0.6, 0.9, 1.1, 2.0, 2.7, 3.4});
  check_kinematics<3>(Tabulated<3>({0, 1, 4}, {{0, 0, 0}, {1, 2, 3}, {-1, 0, 1}}), {0.3, 2.2});
}

TEST_CASE("velocity and acceleration of a tabulated motion are continuous at its inner times") {
  Tabulated<2> const motion(times, places);
  for (double const t : {1.0, 1.2, 2.5}) {
    CHECK((motion.velocity(origin, t + 1e-9) - motion.velocity(origin, t - 1e-9)).norm() < 1e-7);
    CHECK((motion.acceleration(origin, t + 1e-9) - motion.acceleration(origin, t - 1e-9)).norm() < 1e-6);
  }
}

TEST_CASE("a tabulated motion rests before and after its table") {
  Tabulated<2> const motion(times, places);
  for (double const t : {-1.0, 0.5, 3.0, 9.0}) {
    CHECK(motion.velocity(origin, t) == origin);
    CHECK(motion.acceleration(origin, t) == origin);
  }
  CHECK(motion.velocity(origin, 0.5 + 1e-9).norm() < 1e-7);
  CHECK((motion.displaced(origin, 0.0, 99.0) - places[4]).norm() < 1e-15);
  CHECK(Tabulated<2>().displaced(V(1, 2), 0.0, 5.0) == V(1, 2));
}

TEST_CASE("two times make a smooth step") {
  Tabulated<2> const motion({0, 2}, {{0, 0}, {4, 0}});
  CHECK(std::abs(motion.displaced(origin, 0.0, 1.0)[0] - 2) < 1e-15);
  CHECK(std::abs(motion.velocity(origin, 1.0)[0] - 3) < 1e-15);  // 3/2 of the mean
}

TEST_CASE("a bad table stops with a message in words") {
  using Catch::Matchers::StartsWith;
  CHECK_THROWS_WITH(Tabulated<2>({0}, {{0, 0}}), StartsWith("scree: a table of a motion needs 2 to 32 times"));
  CHECK_THROWS_WITH(Tabulated<2>({0, 1}, {{0, 0}}), StartsWith("scree: a table of a motion needs 2 to 32 times"));
  CHECK_THROWS_WITH((Tabulated<2, 4>({0, 1, 2, 3, 4}, std::vector<V>(5, origin))),
                    StartsWith("scree: a table of a motion needs 2 to 4"));
  CHECK_THROWS_WITH(Tabulated<2>({0, 0}, {{0, 0}, {1, 1}}), StartsWith("scree: the times of the table"));
}

TEST_CASE("a step of a tabulated motion is a part of its shortest interval") {
  CHECK(std::abs(Tabulated<2>(times, places).time_step() - 0.02) < 1e-15);
  CHECK(std::isinf(Tabulated<2>().time_step()));
}

}  // namespace scree::test
