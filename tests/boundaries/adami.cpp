// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/boundaries/adami.hpp>

#include "walls.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test {
using namespace fields;
namespace {

template <class Q, class Motion = AtRest>
auto bed(Motion const& motion = {}) {
  return walled_bed<Q, AdamiWalls>(motion);
}

/// Distance of a wall particle from the nearest particle of the material, m.
template <int Dim>
double to_material(Vec<Dim, double> const& x) {
  Vec<Dim, double> const first = Vec<Dim, double>::Constant(0.05), last = Vec<Dim, double>::Constant(0.55);
  return (x - x.cwiseMax(first).cwiseMin(last)).norm();
}

// Calls check(x, u_d, sigma_d, near) for all wall particles, except where rounding decides whether the material is
// within the support of 0.3.
template <class S, class Check>
void for_each_dummy(S& solver, Check const& check) {
  solver.update_diagnostics();
  auto const x = solver.wall().to_host(position);
  auto const u = solver.wall().to_host(dummy_velocity);
  auto const sigma = solver.wall().to_host(stress);
  for (std::size_t j = 0; j < x.size(); ++j) {
    Vec<S::policy::dim, double> const at = x[j].template cast<double>();
    double const distance = to_material(at);
    if (std::abs(distance - 0.3) < 1e-3) continue;
    check(at, u[j].template cast<double>().eval(), sigma[j].template cast<double>().eval(), distance < 0.3);
  }
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("dummy particles of a wall in rigid rotation with the bed turn with it", "", Policies) {
  auto solver = bed<TestType, Rotation>({.rate = 3});
  double worst = 0;
  for_each_dummy(solver, [&](auto const& x, auto const& u, auto const&, bool) {
    worst = std::max(worst, (u - turning(3, x)).norm());
  });
  CHECK(worst < ulps<TestType>(100));
}

TEST_CASE("dummy particles mirror the slip of material at rest past a sliding wall") {
  auto solver = bed<OnHost2, Translation<2>>({{0.5, 0.25}, {}});
  solver.set(velocity, [](auto const&) { return Vec<2, double>(0, 0); });
  int near_ones = 0;
  for_each_dummy(solver, [&](auto const&, auto const& u, auto const& sigma, bool near) {
    CHECK((u - (near ? 2 : 1) * Vec<2, double>(0.5, 0.25)).norm() < 1e-14);
    CHECK(sigma.norm() == (near ? sigma.norm() : 0));
    near_ones += near ? 1 : 0;
  });
  CHECK(near_ones > 40);
}

TEST_CASE("where a wall lets slip, dummy particles mirror the normal part of the slip only") {
  auto solver = bed<OnHost2, Translation<2>>({{0.5, 0.25}, {}});
  solver.set(velocity, [](auto const&) { return Vec<2, double>(0.1, -0.3); });
  solver.set<Wall>(slip_normal, [](auto const&) { return Vec<2, double>(0, 1); });
  for_each_dummy(solver, [&](auto const&, auto const& u, auto const&, bool near) {
    if (near) CHECK((u - Vec<2, double>(0.1, 2 * 0.25 + 0.3)).norm() < 1e-14);
  });
}

TEST_CASE("where a wall lets slip, the shear stress of dummy particles is turned round") {
  auto solver = bed<OnHost2>();
  solver.set(stress, [](auto const&) { return Vec<4, double>(-1, -2, -3, 0.5); });
  auto const of_dummies = [&](double shear) {
    int near_ones = 0;
    for_each_dummy(solver, [&](auto const&, auto const&, auto const& sigma, bool near) {
      if (!near) return;
      ++near_ones;
      CHECK(std::abs(sigma[0] + 1) + std::abs(sigma[2] + 3) + std::abs(sigma[3] - shear) < 1e-14);
    });
    CHECK(near_ones > 40);
  };
  of_dummies(0.5);
  solver.set<Wall>(slip_normal, [](auto const&) { return Vec<2, double>(0, 1); });
  of_dummies(-0.5);
}

TEMPLATE_LIST_TEST_CASE("the stress of dummy particles continues the geostatic one along gravity", "", Policies) {
  auto solver = bed<TestType>();
  set_geostatic(solver);
  double worst = 0;
  for_each_dummy(solver, [&](auto const& x, auto const&, auto const& sigma, bool near) {
    if (near)
      worst = std::max(worst, vertical_error(x, sigma));
    else if (!(sigma.norm() == 0))
      worst = 1e9;
  });
  CHECK(worst < ulps<TestType>(50) * wall_density * wall_gravity * 0.6);
}

// Zhu et al. (2024), eq. 4.3: the printed sign corresponds to reversed gravity.
TEST_CASE("with the printed sign the stress below a bed falls instead of growing") {
  auto const worst_with = [](double magnitude) {
    SolverSettings<WallFormulation<OnHost2, AdamiWalls, AtRest>> settings{.spacing = 0.1};
    settings.diagnostics.gravity.magnitude = magnitude;
    auto const points = open_bed<2>({0.6, 0.6}, 0.1);
    Solver<WallFormulation<OnHost2, AdamiWalls, AtRest>> solver(settings, points.material, points.wall);
    set_geostatic(solver);
    double worst = 0;
    for_each_dummy(solver, [&](auto const& x, auto const&, auto const& sigma, bool near) {
      if (near) worst = std::max(worst, vertical_error(x, sigma));
    });
    return worst / (wall_density * wall_gravity * 0.6);
  };
  CHECK(worst_with(wall_gravity) < 1e-14);
  CHECK(worst_with(-wall_gravity) > 0.5);
}

TEST_CASE("a wall that accelerates adds its inertia to the stress of its dummy particles") {
  // In a freely falling frame the stress does not grow downwards; in one that is lifted with g, it grows twice as fast.
  for (double const lift : {-wall_gravity, wall_gravity}) {
    auto solver = bed<OnHost2, Translation<2>>({{0, 0}, {0, lift}});
    set_geostatic(solver, wall_gravity + lift);
    double worst = 0;
    for_each_dummy(solver, [&](auto const& x, auto const&, auto const& sigma, bool near) {
      if (near) worst = std::max(worst, std::abs(sigma[1] - geostatic<2>(x[1], wall_gravity + lift)[1]));
    });
    CHECK(worst < 1e-10);
  }
}

TEST_CASE("the material sees the dummy velocity, not that of the wall") {
  auto solver = bed<OnHost2, Translation<2>>({{0.5, 0}, {}});
  solver.set(velocity, [](auto const&) { return Vec<2, double>(0, 0); });
  CHECK(worst_of(seen_of_wall(solver), [](auto const& seen) { return (seen.u - Vec<2, double>(1, 0)).norm(); }) <
        1e-14);
}

}  // namespace scree::test
