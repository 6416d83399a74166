// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/boundaries/mirror_lens.hpp>

#include "walls.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::mirror_lens_tests {
using namespace fields;
namespace {

template <class Q, class Motion = AtRest>
auto bed(Motion const& motion = {}) {
  return walled_bed<Q, MirrorWalls>(motion);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("a wall seen by a bed in rigid rotation with it turns with it", "", Policies) {
  auto solver = bed<TestType, Rotation>({.rate = 3});
  auto const error = [](auto const& seen) { return (seen.u - turning(3, seen.x)).norm(); };
  // Ratios of small sums: the smallest weight is 1e-3.
  CHECK(worst_of(seen_of_wall(solver), error) < ulps<TestType>(1e3));
}

TEST_CASE("material at rest sees a sliding wall at twice its speed") {
  auto solver = bed<OnHost2, Translation<2>>({{0.5, 0.25}, {}});
  solver.set(velocity, [](auto const&) { return Vec<2, double>(0, 0); });
  auto const error = [](auto const& seen) { return (seen.u - Vec<2, double>(1, 0.5)).norm(); };
  CHECK(worst_of(seen_of_wall(solver), error) < 1e-14);
}

TEST_CASE("where a wall lets slip, only the normal part of the velocity is mirrored in it") {
  auto solver = bed<OnHost2, Translation<2>>({{0.5, 0.25}, {}});
  solver.set(velocity, [](auto const&) { return Vec<2, double>(0.1, -0.3); });
  solver.set<Wall>(slip_normal, [](auto const&) { return Vec<2, double>(0, 1); });
  auto const error = [](auto const& seen) { return (seen.u - Vec<2, double>(0.1, 2 * 0.25 + 0.3)).norm(); };
  CHECK(worst_of(seen_of_wall(solver), error) < 1e-14);
}

TEST_CASE("where a wall lets slip, the shear stress is turned round in it") {
  auto solver = bed<OnHost2>();
  solver.set(stress, [](auto const&) { return Vec<4, double>(-1, -2, -3, 0.5); });
  auto const shear_is = [&](double shear) {
    return worst_of(seen_of_wall(solver), [&](auto const& seen) { return std::abs(seen.sigma[3] - shear); });
  };
  CHECK(shear_is(0.5) < 1e-14);
  solver.set<Wall>(slip_normal, [](auto const&) { return Vec<2, double>(0, 1); });
  CHECK(shear_is(-0.5) < 1e-14);
}

TEMPLATE_LIST_TEST_CASE("geostatic stress goes on along gravity in the mirror", "", Policies) {
  auto solver = bed<TestType>();
  set_geostatic(solver);
  auto const error = [](auto const& seen) { return vertical_error(seen.x, seen.sigma); };
  CHECK(worst_of(seen_of_wall(solver), error) < ulps<TestType>(1e3) * wall_density * wall_gravity * 0.6);
}

TEST_CASE("a wall that accelerates adds its inertia to the stress in the mirror") {
  for (double const lift : {-wall_gravity, wall_gravity}) {
    auto solver = bed<OnHost2, Translation<2>>({{0, 0}, {0, lift}});
    double const g = wall_gravity + lift;
    set_geostatic(solver, g);
    auto const error = [&](auto const& seen) { return std::abs(seen.sigma[1] - geostatic<2>(seen.x[1], g)[1]); };
    CHECK(worst_of(seen_of_wall(solver), error) < 1e-9);
  }
}

TEST_CASE("a mirror needs no passes over the wall") {
  STATIC_CHECK(std::is_same_v<decltype(MirrorWalls{}.stress_passes(UniformDensity{1}, Gravity{})), std::tuple<>>);
  // Only the fields of the motion: no stress, no sums.
  using Carried = wall_fields<WallFormulation<OnHost2, MirrorWalls, AtRest>>;
  STATIC_CHECK_FALSE(OneOf<Stress, Carried>);
  STATIC_CHECK_FALSE(OneOf<Weight, Carried>);
}

}  // namespace scree::test::mirror_lens_tests
