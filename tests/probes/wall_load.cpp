// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "still.hpp"

#include <scree/probes/wall_load.hpp>

#include <catch2/catch_test_macros.hpp>

namespace scree::test {

// The floor of unit_block(): in the plane four particles, at (-0.15, -0.15), (-0.05, -0.15), (-0.15, -0.05), (-0.05,
// -0.05), each with the force (1, 2).
TEST_CASE("the load on walls is the sum of the forces and of their torques about a point") {
  auto block = unit_block<2>();
  auto const load = wall_load(block, {0, 0});
  CHECK(norm(Vec<2, double>(load.force - Vec<2, double>(4, 8))) < 1e-14);
  CHECK(std::abs(load.torque[0] - (-0.1 * 8 + 0.1 * 4)) < 1e-14);
  CHECK(std::abs(wall_load(block, {-0.1, -0.1}).torque[0]) < 1e-14);
  auto const two = wall_load(block, {0, 0}, {1, 3});
  CHECK(norm(Vec<2, double>(two.force - Vec<2, double>(2, 4))) < 1e-14);
  CHECK(std::abs(two.torque[0] - (-0.05 * 2 + 0.15 * 1 - 0.15 * 2 + 0.05 * 1)) < 1e-14);
  CHECK(wall_load(block, {0, 0}, {2, 2}).force.isZero());
}

TEST_CASE("in three dimensions the torque is a vector") {
  auto block = unit_block<3, float>();
  auto const load = wall_load(block, {-0.1, -0.1, 0.4});  // an arm of (0, 0, -0.5) from the point to the centre
  CHECK(norm(Vec<3, double>(load.force - Vec<3, double>(8, 0, 16))) < 1e-5);
  CHECK(norm(Vec<3, double>(load.torque - Vec<3, double>(0, -4, 0))) < 1e-5);
}

}  // namespace scree::test
