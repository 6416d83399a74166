// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/boundaries/adami.hpp>

#include "walls.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <numbers>

namespace scree::test::adami_tests {
using namespace fields;
namespace {

template <class Q, class Motion = AtRest>
auto bed(Motion const& motion = {}) {
  return walled_bed<Q, AdamiWalls>(motion);
}
/// In a field of gravity of its own, in the direction of `inclination`.
auto bed_under(Gravity const& gravity) {
  SolverSettings<WallFormulation<OnHost2, AdamiWalls, AtRest>> settings{.spacing = 0.1};
  settings.diagnostics.gravity = gravity;
  auto const points = open_bed<2>({0.6, 0.6}, 0.1);
  return Solver<WallFormulation<OnHost2, AdamiWalls, AtRest>>(settings, points.material, points.wall);
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
  auto solver = bed_under({.magnitude = 0});
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

// Also next to and above the bed, and in its corners.
TEMPLATE_LIST_TEST_CASE("the stress of dummy particles continues a hydrostatic one in all places", "", Policies) {
  auto solver = bed<TestType>();
  set_geostatic(solver, wall_gravity, 1);
  double worst = 0;
  for_each_dummy(solver, [&](auto const& x, auto const&, auto const& sigma, bool near) {
    constexpr int dim = TestType::dim;
    auto const exact = geostatic<dim>(x[dim - 1], wall_gravity, 1);
    for (int k = 0; k < sigma.size(); ++k)
      if (dim == 3 || k != 2) worst = std::max(worst, std::abs(sigma[k] - (near ? exact[k] : 0)));
  });
  CHECK(worst < ulps<TestType>(50) * wall_density * wall_gravity * 0.6);
}

TEST_CASE("below and beside a bed the stress of dummy particles continues a geostatic one on the wall") {
  auto solver = bed<OnHost2>();
  set_geostatic(solver);
  int below = 0, beside = 0;
  for_each_dummy(solver, [&](auto const& x, auto const&, auto const& sigma, bool near) {
    if (!near) return;
    bool const middle = std::abs(x[0] - 0.3) < 0.06, half_way = std::abs(x[1] - 0.3) < 0.06;
    if (!middle && !half_way) return;
    Vec<2, double> const n = middle ? Vec<2, double>::UnitY() : Vec<2, double>::UnitX();
    Vec<4, double> const off = sigma - geostatic<2>(x[1]);
    CHECK(product(off, n).norm() < 1e-10);
    (middle ? below : beside) += 1;
  });
  CHECK((below > 2 && beside > 4));
}

// The stress of a layer under a surface z = 0.6 or x = 0 on a rough slope of 20 degrees, and beneath a surface at any
// angle to the axes the rotated one: tests/boundaries/wall.cpp.
TEST_CASE("dummy particles below a layer on a slope show its traction at their depth") {
  double const slope = 0.35;
  for (bool const below : {true, false}) {
    auto solver = bed_under({wall_gravity, below ? slope : std::numbers::pi / 2 + slope});
    // Depth under the surface, and the weight across and along it.
    auto const depth = [below](auto const& x) { return below ? 0.6 - x[1] : x[0]; };
    double const across = wall_density * wall_gravity * std::cos(slope);
    double const along = wall_density * wall_gravity * std::sin(slope);
    auto const exact = [&](auto const& x) {
      double const y = depth(x);
      return Vec<4, double>(-across * y, -across * y, -across * y, (below ? along : -along) * y);
    };
    solver.set(stress, exact);
    int seen = 0;
    for_each_dummy(solver, [&](auto const& x, auto const&, auto const& sigma, bool near) {
      bool const floor = below ? x[1] < 0 && std::abs(x[0] - 0.3) < 0.06 : x[0] > 0.6 && std::abs(x[1] - 0.3) < 0.06;
      if (!near || !floor) return;
      Vec<2, double> const n = below ? Vec<2, double>::UnitY() : Vec<2, double>::UnitX();
      CHECK(product((sigma - exact(x)).eval(), n).norm() < 1e-10);
      ++seen;
    });
    CHECK(seen > 2);
  }
}

// Zhu et al. (2024), eq. 4.3: the printed sign corresponds to reversed gravity.
TEST_CASE("with the printed sign the stress below a bed falls instead of growing") {
  auto const worst_with = [](double magnitude) {
    auto solver = bed_under({.magnitude = magnitude});
    set_geostatic(solver, wall_gravity, 1);
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
    set_geostatic(solver, wall_gravity + lift, 1);
    double worst = 0;
    for_each_dummy(solver, [&](auto const& x, auto const&, auto const& sigma, bool near) {
      if (near) worst = std::max(worst, std::abs(sigma[1] - geostatic<2>(x[1], wall_gravity + lift, 1)[1]));
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

}  // namespace scree::test::adami_tests
