// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/integrators/velocity_verlet.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/motion/translation.hpp>

#include <support/rigid_bodies.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>

// Rigid bodies on floors: at rest, carried, restarted, and refused.
namespace scree::test::at_rest_tests {
using namespace fields;
namespace {

using Catch::Matchers::ContainsSubstring;
constexpr double dr = 0.02, g = 10;

/// Blocks on each other on a floor.
template <class F>
Solver<F> stacked(int number, RigidContact const& contact, double above = 0, typename F::motion const& motion = {},
                  [[maybe_unused]] bool turns = false) {
  constexpr int dim = F::dim;
  using X = Vec<dim, double>;
  RigidBodies<dim> rigid{.bodies = {}, .contact = contact};
  Groups<dim> blocks;
  for (int k = 0; k < number; ++k) {
    X low = X::Constant(-0.06), high = X::Constant(0.06);
    low[dim - 1] = 0.08 * k + above, high[dim - 1] = 0.08 * (k + 1) + above;
    rigid.bodies.push_back({.properties = mass_properties(Box<dim>{low, high}, 2000, dr)});
    if constexpr (requires { motion.rate; })
      if (turns) {
        rigid.bodies.back().velocity[0] = -motion.rate * (low[dim - 1] + high[dim - 1]) / 2;
        rigid.bodies.back().angular_velocity[0] = motion.rate;
      }
    blocks.add("block " + std::to_string(k), fill_lattice(Box<dim>{low, high}, dr));
  }
  using Real = typename F::real;
  return Solver<F>({.spacing = dr, .physics = {.gravity = {g}}, .motion = motion, .rigid = rigid},
                   particles_of<Material>(std::vector<Vec<dim, Real>>()),
                   particles_of<Wall>(cast<Real>(floor_of<dim>(dim == 2 ? 0.3 : 0.1, dr))),
                   particles_of<Block>(blocks));
}
template <class Integrator = SymplecticEuler, class Motion = AtRest>
using In2D = Free<Policy<2, double, Kokkos::DefaultHostExecutionSpace>, Integrator, Motion>;
}  // namespace

TEMPLATE_LIST_TEST_CASE("blocks on each other on a floor come to rest and bear their weight", "", Policies) {
  using Q = TestType;
  constexpr int top = Q::dim - 1;
  double const E = 5e6, e = 0.5;
  auto solver = stacked<Free<Q, SymplecticEuler>>(2, {.modulus = E, .restitution = e});
  advance_to(solver, 0.2);
  auto const a = state_of(solver, 0), b = state_of(solver, 1);
  advance_to(solver, 0.4);
  auto const c = state_of(solver, 0), d = state_of(solver, 1);
  double const pressure = 2 * 2000 * g * 0.08, exact = pressure * dr / E / ((1 + e * e) / 2);
  double const sunk = 0.04 - c.x[top], weight = solver.settings().rigid.bodies[0].properties.mass * g;
  INFO("creeps by " << (c.x - a.x).norm() / 0.2 << ", " << (d.x - b.x).norm() / 0.2 << " m/s; sunk by " << sunk / exact
                    << " of the stated overlap; force over weight " << c.force[top] / weight << ", "
                    << d.force[top] / weight);
  CHECK((c.x - a.x).norm() / 0.2 < 1e-8);
  CHECK((d.x - b.x).norm() / 0.2 < 1e-8);
  CHECK(std::abs(sunk / exact - 1) < 0.06);
  CHECK(std::abs(c.force[top] / weight - 1) < 0.01);
  CHECK(std::abs(d.force[top] / weight - 1) < 0.01);
}

TEST_CASE("a block on a belt is dragged by friction until it moves with it") {
  double const mu = 0.3, speed = 0.3;
  auto solver =
      stacked<In2D<SymplecticEuler, Translation<2>>>(1, {.modulus = 5e6, .friction = mu}, 0, {.speed = {speed, 0}});
  advance_to(solver, 0.02);
  double const u0 = state_of(solver).u[0];
  advance_to(solver, 0.08);
  double const u1 = state_of(solver).u[0];
  INFO("acceleration over mu g " << (u1 - u0) / 0.06 / (mu * g));
  CHECK(std::abs((u1 - u0) / 0.06 / (mu * g) - 1) < 0.02);
  advance_to(solver, 0.25);
  INFO("speed over that of the belt " << state_of(solver).u[0] / speed);
  CHECK(std::abs(state_of(solver).u[0] / speed - 1) < 1e-3);
}

TEST_CASE("a block on a table that tilts slides off at the angle of friction") {
  double const mu = 0.3, rate = 0.3;
  auto solver = stacked<In2D<SymplecticEuler, Rotation>>(1, {.modulus = 2e7, .friction = mu}, 0, {.rate = rate}, true);
  double slid = 0, angle = 0;
  while (std::abs(slid) < 1e-3 && solver.time() < 2) {
    solver.step(1);
    angle = rate * solver.time();
    auto const now = state_of(solver);
    slid = now.x[0] * std::cos(angle) + now.x[1] * std::sin(angle);
  }
  // It has moved by 1 mm since: s = g/sqrt(1 + mu^2) rate t^3/6 above the angle.
  double const since = std::cbrt(6 * 1e-3 / (g * std::sqrt(1 + mu * mu) * rate)), exact = std::atan(mu) + rate * since;
  INFO("slides at " << angle << " instead of " << exact << ", turned by " << state_of(solver).q[0]);
  CHECK(std::abs(angle - exact) < 0.01);
  CHECK(std::abs(state_of(solver).q[0] - angle) < 2e-3);
}

TEMPLATE_TEST_CASE("a body in contact goes on from a snapshot bit for bit", "", Midpoint, SymplecticEuler,
                   VelocityVerlet) {
  using F = In2D<TestType, Translation<2>>;
  auto const make = [] { return stacked<F>(2, {.modulus = 5e6, .friction = 0.3}, 0.0005, {.speed = {0.1, 0}}); };
  auto before = make(), after = make();
  while (before.time() < 0.02) before.step(1);
  CHECK(state_of(before).force.norm() > 0);
  CHECK(before.template body<Block>().to_host(contact_stretch)[0].norm() > 0);
  after.restore(before.snapshot());
  after.check_start();  // changes nothing
  for (int k = 0; k < 60; ++k) before.step(1), after.step(1);
  CHECK(before.time() == after.time());
  for (std::size_t k : {0, 1}) {
    auto const a = state_of(before, k), b = state_of(after, k);
    CHECK(a.x == b.x);
    CHECK(a.u == b.u);
    CHECK(a.q == b.q);
    CHECK(a.force == b.force);
  }
  CHECK(before.template body<Block>().to_host(contact_stretch) ==
        after.template body<Block>().to_host(contact_stretch));
}

TEST_CASE("a body that enters another or a wall is reported where contact does not act") {
  auto const run = [](RigidContact const& contact) {
    auto solver = stacked<In2D<Midpoint>>(1, contact, 0.01);
    solver.run(0.2);
    return state_of(solver).x[1];
  };
  CHECK_THROWS_WITH(run({}), ContainsSubstring("overlap of rigid bodies with each other or with walls") &&
                                 ContainsSubstring("contact does not act: set `modulus` of `rigid.contact`"));
  CHECK_THROWS_AS(run({.acts = false, .modulus = 1e6}), OutsideValidity);
  CHECK(run({.acts = false, .largest_overlap = std::numeric_limits<double>::infinity()}) < -0.1);
  CHECK_THROWS_WITH(run({.modulus = 100}), ContainsSubstring("`modulus` of `rigid.contact` makes contact stiffer"));
  CHECK(run({.modulus = 1e7}) > 0.0399);
  // A body that is made within a floor.
  auto within = stacked<In2D<Midpoint>>(1, {.modulus = 1e6}, -0.9 * dr);
  CHECK_THROWS_WITH(within.step(1), ContainsSubstring("bodies that are made in contact must not overlap"));
}

}  // namespace scree::test::at_rest_tests
