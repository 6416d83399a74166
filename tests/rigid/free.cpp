// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/integrators/velocity_verlet.hpp>

#include <support/rigid_bodies.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <numbers>

// Rigid bodies without grains.
namespace scree::test::free_tests {
using namespace fields;
namespace {
using Catch::Matchers::ContainsSubstring;

template <class Integrator>
using In3D = Free<Policy<3, double, Kokkos::DefaultHostExecutionSpace>, Integrator>;

template <class F>
Solver<F> solver_with(RigidBodies<F::dim> const& rigid, double gravity, int particles_of_each = 3) {
  std::vector<Points<F::dim>> blocks;
  for (auto const& body : rigid.bodies) {
    Points<F::dim> points;
    for (int n = 0; n < particles_of_each; ++n)
      points.push_back(body.properties.centre + 0.1 * n * Vec<F::dim, double>::Unit(n % F::dim));
    blocks.push_back(points);
  }
  return solver_of_bodies<F>(0.1, rigid, {gravity}, blocks);
}
template <int Dim>
Rigid<Dim> some_body() {
  Rigid<Dim> body;
  body.properties.mass = 2;
  body.properties.centre[0] = 0.3;
  body.properties.inertia = 0.7 * Inertia<Dim>::Identity();
  return body;
}
}  // namespace

TEMPLATE_LIST_TEST_CASE("a rigid body falls and turns freely, its particles with it", "", Policies) {
  using Q = TestType;
  auto body = some_body<Q::dim>(), other = body;
  other.properties.centre[0] = -1;
  body.velocity[0] = 0.4;
  body.angular_velocity[0] = 1.5;
  auto solver = solver_with<Free<Q>>({.bodies = {other, body}}, 10);
  double const end = 0.5;
  while (solver.time() < end) solver.step(std::min(0.01, end - solver.time()));
  auto const& states = solver.template body<RigidStates>();
  auto const x = states.to_host(rigid_centre);
  auto const u = states.to_host(rigid_velocity);
  Vec<Q::dim, double> exact = body.properties.centre + body.velocity * end;
  exact[Q::dim - 1] -= 10 * end * end / 2;
  CHECK((x[1] - exact).norm() < 1e-13);
  CHECK(std::abs(x[0][0] + 1) < 1e-15);
  CHECK(std::abs(u[1][Q::dim - 1] + 10 * end) < 1e-13);
  // The particle at 0.1 along the second axis from the centre.
  auto const places = solver.template body<Block>().to_host(position);
  auto const speeds = solver.template body<Block>().to_host(velocity);
  Vec<Q::dim, double> arm = zero<Vec<Q::dim, double>>(), turning = arm;
  double const angle = 1.5 * end;
  if constexpr (Q::dim == 2)
    arm << -0.1 * std::sin(angle), 0.1 * std::cos(angle), turning << -1.5 * arm[1], 1.5 * arm[0];
  else
    arm << 0, 0.1 * std::cos(angle), 0.1 * std::sin(angle), turning << 0, -1.5 * arm[2], 1.5 * arm[1];
  CHECK((places[4].template cast<double>() - exact - arm).norm() < ulps<Q>(30));
  CHECK((speeds[4].template cast<double>() - u[1] - turning).norm() < ulps<Q>(30));
}

TEMPLATE_TEST_CASE("torque-free rotation with three moments of inertia keeps energy and angular momentum", "", Midpoint,
                   SymplecticEuler, VelocityVerlet) {
  using F = In3D<TestType>;
  auto body = some_body<3>();
  body.properties.inertia = Vec<3, double>(1, 2, 2.6).asDiagonal();
  body.angular_velocity = {0.3, 4, 0.2};  // about the unstable axis
  auto solver = solver_with<F>({.bodies = {body}}, 0);
  auto const& states = solver.template body<RigidStates>();
  auto const energy = [&] { return states.to_host(angular_momentum)[0].dot(states.to_host(angular_velocity)[0]) / 2; };
  auto const L0 = states.to_host(angular_momentum)[0];
  double const E0 = energy(), end = 100 * 2 * std::numbers::pi / 4;
  double drift = 0, tumbled = 1;
  while (solver.time() < end) {
    solver.step(0.01);
    drift = std::max(drift, std::abs(energy() / E0 - 1));
    Mat<3, double> const R = matrix_of(states.to_host(rigid_attitude)[0]);
    tumbled = std::min(tumbled, R(1, 1));
  }
  CHECK(tumbled < -0.9);  // it turns over, again and again
  CHECK((states.to_host(angular_momentum)[0] - L0).norm() == 0);
  CHECK(drift < 1e-4);
  CHECK(std::abs(states.to_host(rigid_attitude)[0].norm() - 1) < 1e-14);
  UNSCOPED_INFO("largest relative change of the energy: " << drift);
  CHECK(drift > 0);
}

TEST_CASE("given components of the motion are kept, and the others follow the forces") {
  using F = In3D<Midpoint>;
  auto body = some_body<3>();
  body.properties.inertia << 1, 0.2, 0, 0.2, 1.5, 0.1, 0, 0.1, 2;
  body.given_velocity = {0.5, 0.0, {}};
  body.given_turning = {std::nullopt, -2.0, 0.0};
  auto solver = solver_with<F>({.bodies = {body}}, 10);
  while (solver.time() < 0.3) solver.step(0.01);
  auto const& states = solver.body<RigidStates>();
  auto const u = states.to_host(rigid_velocity)[0], w = states.to_host(angular_velocity)[0];
  CHECK(u[0] == 0.5);
  CHECK(u[1] == 0);
  CHECK(std::abs(u[2] + 10 * solver.time()) < 1e-13);
  CHECK(std::abs(w[1] + 2) < 1e-14);
  CHECK(std::abs(w[2]) < 1e-14);
  CHECK(std::abs(states.to_host(rigid_centre)[0][0] - 0.3 - 0.5 * solver.time()) < 1e-14);
  // The free component keeps its angular momentum, -2 J_xy, also where the axes of the body have turned.
  Vec<3, double> const L = in_space(body.properties.inertia, states.to_host(rigid_attitude)[0]) * w;
  CHECK(std::abs(L[0] + 0.4) < 1e-13);
}

TEST_CASE("a rigid body whose state is not a number stops the run") {
  using F = Free<Policy<2, double, Kokkos::DefaultHostExecutionSpace>>;
  auto other = some_body<2>();
  other.properties.centre[0] = -1;
  auto solver = solver_with<F>({.bodies = {some_body<2>(), other}}, 10);
  solver.step(0.01);
  solver.set<RigidStates>(rigid_velocity, [](auto const&) { return Vec<2, double>(0, std::nan("")); });
  CHECK_THROWS_WITH(solver.step(0.01), ContainsSubstring("the rigid bodies limit of the time step is "));
}

TEST_CASE("settings of rigid bodies that are wrong are refused") {
  using F = In3D<Midpoint>;
  auto body = some_body<3>();
  body.properties.mass = 0;
  CHECK_THROWS_WITH(solver_with<F>({.bodies = {some_body<3>(), body}}, 0),
                    ContainsSubstring("mass of a rigid body (kg) must be above 0, not 0 (rigid body 1)"));
  body.properties.mass = 1;
  body.properties.inertia = Vec<3, double>(1, 1, 3).asDiagonal();
  CHECK_THROWS_WITH(solver_with<F>({.bodies = {body}}, 0), ContainsSubstring("at most the sum of the other two"));
  CHECK_THROWS_WITH(solver_with<F>({.bodies = {some_body<3>()}}, 0, 0),
                    ContainsSubstring("each rigid body needs one group with particles"));
  Groups<3> blocks;
  blocks.add("block", {{0, 0, 0}});
  SolverSettings<F> settings{.spacing = 0.1, .rigid = {.bodies = {some_body<3>()}}, .periods = {{1, 0, 1}}};
  auto const make = [&] {
    return Solver<F>(settings, particles_of<Material>(std::vector<Vec<3, double>>()), particles_of<Block>(blocks));
  };
  CHECK_THROWS_WITH(make(), ContainsSubstring("must not move along the period of axis 1"));
  settings.rigid.bodies[0].given_velocity[1] = 0;
  settings.rigid.bodies[0].given_turning = {0.0, {}, 0.0};
  CHECK_NOTHROW(make());
}

}  // namespace scree::test::free_tests
