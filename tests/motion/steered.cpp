// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/motion/steered.hpp>

#include "kinematics.hpp"

#include <catch2/matchers/catch_matchers_string.hpp>

#include <stdexcept>

namespace scree::test::steered_tests {
using Catch::Matchers::ContainsSubstring;
using V = Vec<2, double>;

TEST_CASE("a steered motion goes on from where it is with the velocity that it is given") {
  Steered<2> const at_rest;
  check_kinematics<2>(at_rest, {0.0, 3.0});
  auto const first = at_rest.turned_to(V(1, 0), 0.5), second = first.turned_to(V(0, -2), 1.5);
  check_kinematics<2>(second, {1.6, 3.0});
  check_kinematics<3>(Steered<3>{}.turned_to({0.1, 0.2, -0.3}, 0), {0.0, 3.0});
  CHECK(first.displaced(V(0, 0), 0.0, 0.5) == V(0, 0));
  CHECK(second.displaced(V(0, 0), 0.0, 1.5) == V(1, 0));
  CHECK(second.displaced(V(0, 0), 0.0, 2.0) == V(1, -1));
  CHECK(second.velocity(V(5, 5), 2.0) == V(0, -2));
  // What was before the last change is forgotten, but not the way.
  CHECK(second.displaced(V(0, 0), 0.0, 0.75) == V(0.5, 0));
  CHECK(std::isinf(second.time_step()));
}

TEST_CASE("a steered motion does not turn in the past, and begins at its place") {
  CHECK_THROWS_WITH(Steered<2>{.since = 1}.turned_to(V(1, 0), 0.5), ContainsSubstring("the last change or later"));
  CHECK_THROWS_WITH((Steered<2>{.way = {1, 0}}.check()), ContainsSubstring("way (m) of Steered at time zero"));
  CHECK_THROWS_AS((Steered<2>{.since = -1}.check()), std::invalid_argument);
}

}  // namespace scree::test::steered_tests
