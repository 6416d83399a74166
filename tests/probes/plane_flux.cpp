// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "still.hpp"

#include <scree/openings/regions.hpp>
#include <scree/probes/plane_flux.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <limits>

namespace scree::test::plane_flux_tests {
using namespace fields;
namespace {
HalfSpace<2> const below_middle{.point = {0, 0.5}, .normal = {0, 2}};
bool near(double a, double b) { return std::abs(a - b) < 1e-12; }
}  // namespace

TEST_CASE("volume that passes a plane is counted once, whatever the interval between two calls") {
  for (int const calls : {1, 4, 50}) {
    auto block = unit_block<2>();
    block.set(velocity, [](auto const&) { return Vec<2, double>(0, 0.3); });
    PlaneFlux<2> flux(block, below_middle);
    double passed = 0;
    for (int k = 1; k <= calls; ++k) {
      block.run(double(k) / calls);
      passed += flux.passed(block).net();
    }
    CHECK(near(passed, 0.3));  // three rows of ten
    CHECK(flux.passed(block).forward == 0);
    CHECK(flux.passed(block).backward == 0);
  }
}

TEST_CASE("volume that comes back counts against the normal") {
  auto block = unit_block<2>();
  PlaneFlux<2> flux(block, below_middle);
  block.set(position, [](auto const& x) { return Vec<2, double>(x[0], x[1] + 0.2); });
  CHECK(near(flux.passed(block).net(), 0.2));
  block.set(position, [](auto const& x) { return Vec<2, double>(x[0], x[1] - 0.3); });
  CHECK(near(flux.passed(block).net(), -0.3));
  block.set(position, [](auto const& x) { return Vec<2, double>(1 - x[0], 1 - x[1]); });  // 6 rows up, 4 down
  CHECK(near(flux.passed(block).net(), 0.2));
}

TEST_CASE("particles are known by identity when they are sorted in memory") {
  auto block = unit_block<2>({}, 1);
  block.set(position, [](auto const& x) { return Vec<2, double>(x[0], 1 - x[1]); });  // an order that sorting changes
  block.set(velocity, [](auto const& x) { return Vec<2, double>(0, x[0] < 0.5 ? 0.2 : -0.1); });
  PlaneFlux<2> flux(block, below_middle);
  auto const before = block.material().to_host(identity);
  for (int k = 0; k < 10; ++k) block.step(0.1);
  CHECK(block.material().to_host(identity) != before);
  auto const passed = flux.passed(block);
  CHECK(near(passed.forward, 0.1));
  CHECK(near(passed.backward, 0.05));
}

TEST_CASE("a plane where the count would be wrong is refused") {
  auto const block = unit_block<2>({{.axis = 0, .low = 0, .high = 1}});
  CHECK_NOTHROW(PlaneFlux<2>(block, below_middle));
  CHECK_THROWS_AS(PlaneFlux<2>(block, {.point = {0.5, 0}, .normal = {1, 0}}), std::invalid_argument);
  CHECK_THROWS_AS(PlaneFlux<2>(block, {.point = {0.5, 0}, .normal = {0.01, 1}}), std::invalid_argument);
  for (double const bad : {0.0, std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_AS(PlaneFlux<2>(block, {.point = {0.5, 0}, .normal = {bad, bad}}), std::invalid_argument);
}

TEST_CASE("particles that came or went before a plane counts do not matter, and those that do so later are refused") {
  auto block = unit_block<2>();
  long const all = block.material().size();
  block.remove(Within<2>{{0, 0}, {0.2, 1}});
  REQUIRE(block.material().size() < all);
  block.set(velocity, [](auto const&) { return Vec<2, double>(0, 0.3); });
  PlaneFlux<2> flux(block, below_middle);
  block.run(1);
  CHECK(near(flux.passed(block).net(), 0.24));  // eight of ten columns
  block.remove(Within<2>{{0.2, 0}, {0.3, 2}});
  CHECK_THROWS_WITH(flux.passed(block), Catch::Matchers::ContainsSubstring("came or went"));
  PlaneFlux<2> again(block, below_middle);
  block.remove(Within<2>{{0.3, 1.15}, {0.4, 1.25}});
  block.add({{0.35, 1.2}});
  CHECK_THROWS_WITH(again.passed(block), Catch::Matchers::ContainsSubstring("came or went"));
}

TEST_CASE("a plane counts the particles of one solver") {
  auto const block = unit_block<2>();
  PlaneFlux<2> flux(block, below_middle);
  Solver<Still<2>> const other({.spacing = 0.1, .physics = {}, .start_checks = false}, {{0, 0}});
  CHECK_THROWS_AS(flux.passed(other), std::invalid_argument);
}

}  // namespace scree::test::plane_flux_tests
