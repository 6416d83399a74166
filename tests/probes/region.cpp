// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "still.hpp"

#include <scree/probes/region.hpp>

#include <catch2/catch_test_macros.hpp>

namespace scree::test::region_tests {
using namespace fields;

TEST_CASE("the mean in a region counts each particle in it with its volume") {
  auto block = unit_block<2>();
  block.set(concentration, [](auto const& x) { return x[1] < 0.1 ? 1.0 : 5.0; });
  block.set(volume, [](auto const& x) { return x[1] < 0.1 ? 0.03 : 0.01; });
  auto const mean = mean_in(block, concentration, Box<2>{{0, 0}, {1, 0.2}});  // two rows
  CHECK(mean.particles == 20);
  CHECK(std::abs(mean.volume - 0.4) < 1e-14);
  CHECK(std::abs(mean.value - (0.3 * 1 + 0.1 * 5) / 0.4) < 1e-14);
}

TEST_CASE("vectors and derived fields have means in regions of any shape") {
  auto block = unit_block<3, float>();
  block.set(velocity, [](auto const& x) { return Vec<3, float>(x[0], 1, x[2] - 0.5f); });
  block.set(stress, [](auto const&) { return Vec<6, float>(-3, -3, -3, 1, 1, 1); });
  Ball<3> const ball{.centre = {0.5, 0.5, 0.5}, .radius = 0.3};
  auto const mean = mean_in(block, velocity, ball);
  CHECK(norm(Vec<3, double>(mean.value - Vec<3, double>(0.5, 1, 0))) < 1e-6);
  CHECK(std::abs(mean_in(block, pressure, ball).value - 3) < 1e-6);
  CHECK(mean_in(block, pressure, ball).particles == mean.particles);
}

TEST_CASE("a region without particles has no mean") {
  auto const block = unit_block<2>();
  auto const mean = mean_in(block, position, Ball<2>{.centre = {5, 5}, .radius = 1});
  CHECK(mean.particles == 0);
  CHECK(mean.volume == 0);
  CHECK(std::isnan(mean.value[0]));
}

}  // namespace scree::test::region_tests
