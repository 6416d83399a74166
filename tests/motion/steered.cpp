// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/motion/steered.hpp>

#include "kinematics.hpp"

#include <catch2/matchers/catch_matchers_string.hpp>

#include <stdexcept>

namespace scree::test::steered_tests {
using Catch::Matchers::ContainsSubstring;
using V = Vec<2, double>;

TEST_CASE("a steered motion continues from where it is with the velocity that it is given") {
  Steered<2> const at_rest;
  check_kinematics<2>(at_rest, {0.0, 3.0});
  auto const first = at_rest.turned_to(V(1, 0), 0.5), second = first.turned_to(V(0, -2), 1.5);
  check_kinematics<2>(second, {1.6, 3.0});
  check_kinematics<3>(Steered<3>{}.turned_to({0.1, 0.2, -0.3}, 0), {0.0, 3.0});
  CHECK(first.displaced(V(0, 0), 0.0, 0.5) == V(0, 0));
  CHECK(second.displaced(V(0, 0), 0.0, 1.5) == V(1, 0));
  CHECK(second.displaced(V(0, 0), 0.0, 2.0) == V(1, -1));
  CHECK(second.velocity(V(5, 5), 2.0) == V(0, -2));
  // Changes before the last one are forgotten, but not the displacement.
  CHECK(second.displaced(V(0, 0), 0.0, 0.75) == V(0.5, 0));
  CHECK(std::isinf(second.time_step()));
}

TEST_CASE("a steered motion does not turn in the past, and begins at its place") {
  CHECK_THROWS_WITH(Steered<2>{.since = 1}.turned_to(V(1, 0), 0.5), ContainsSubstring("the last change or later"));
  CHECK_THROWS_WITH((Steered<2>{.way = {1, 0}}.check()), ContainsSubstring("way (m) of Steered at time zero"));
  CHECK_THROWS_AS((Steered<2>{.since = -1}.check()), std::invalid_argument);
}

TEST_CASE("a steered motion is the same after it has been written as numbers and read from them") {
  auto const flat = Steered<2>{}.turned_to(V(1, 0.25), 0.5).turned_to(V(0, -2), 1.5);
  CHECK(flat.numbers() == std::vector<double>{1.5, 1, 0.25, 0, -2});
  auto const deep = Steered<3>{}.turned_to({1, 2, 3}, 0).turned_to({-4, 5, 6}, 2);
  auto numbers = deep.numbers();
  CHECK(numbers.size() == Steered<3>::number_count);
  numbers.push_back(7);  // of the component that keeps the motion
  auto const read = Steered<3>::from_numbers(numbers);
  CHECK((read.since == 2 && read.way == deep.way && read.velocity_now == deep.velocity_now));
  CHECK_THROWS_WITH(Steered<3>::from_numbers(flat.numbers()),
                    ContainsSubstring("numbers of Steered must be 7 or more, not 5"));
  CHECK_THROWS_AS(Steered<2>::from_numbers(std::vector<double>{-1, 0, 0, 0, 0}), std::invalid_argument);
}

}  // namespace scree::test::steered_tests
