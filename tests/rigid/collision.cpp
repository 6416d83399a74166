// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/integrators/symplectic_euler.hpp>

#include <support/rigid_bodies.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

// Contact of rigid bodies with each other.
namespace scree::test::collision_tests {
namespace {

constexpr double dr = 0.02;
template <int Dim>
struct Motion {
  Vec<Dim, double> momentum = Vec<Dim, double>::Zero();
  Turn<Dim> about_origin = Turn<Dim>::Zero();
  double energy = 0;
};
template <class S>
auto motion_of_all(S const& solver) {
  Motion<S::policy::dim> sum;
  auto const& bodies = solver.settings().rigid.bodies;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    auto const now = state_of(solver, k);
    double const m = bodies[k].properties.mass;
    sum.momentum += m * now.u;
    sum.about_origin += now.L + moment_of(now.x, (m * now.u).eval());
    sum.energy += (m * squared_norm(now.u) + dot(now.L, now.w)) / 2;
  }
  return sum;
}
/// Runs until bodies have touched and separated for good.
template <class S>
void collide(S& solver) {
  int apart = 0;
  bool touched = false;
  for (int k = 0; k < 100000 && apart < 100; ++k) {
    solver.step(1e-3);
    bool const touches = state_of(solver).force.norm() > 0;
    touched = touched || touches;
    apart = touched && !touches ? apart + 1 : 0;
  }
}
}  // namespace

TEMPLATE_LIST_TEST_CASE("bodies that collide head on keep their momentum and lose the energy of the restitution", "",
                        Policies) {
  using Q = TestType;
  constexpr int dim = Q::dim;
  using X = Vec<dim, double>;
  double const e = 0.6;
  X size = X::Constant(0.12);
  Box<dim> const left{X::Zero(), size},
      right{size[0] * X::Unit(0) + 0.1 * dr * X::Unit(0), size + (size[0] + 0.1 * dr) * X::Unit(0)};
  Rigid<dim> a, b;
  a.properties = mass_properties(left, 2000, dr), b.properties = mass_properties(right, 3000, dr);
  a.velocity[0] = 1, b.velocity[0] = -0.5;
  auto solver =
      solver_of_bodies<Free<Q, SymplecticEuler>>(dr, {.bodies = {a, b}, .contact = {.modulus = 2e7, .restitution = e}},
                                                 {0}, {fill_lattice(left, dr), fill_lattice(right, dr)});
  auto const before = motion_of_all(solver);
  collide(solver);
  auto const after = motion_of_all(solver);
  double const m = a.properties.mass, n = b.properties.mass, relative = 1.5;
  double const loss = m * n / (m + n) / 2 * relative * relative * (1 - e * e);
  INFO("loss of energy over exact " << (before.energy - after.energy) / loss << ", change of momentum "
                                    << (after.momentum - before.momentum).norm() / (m * 1) << ", speed of separation "
                                    << state_of(solver, 1).u[0] - state_of(solver, 0).u[0]);
  CHECK((after.momentum - before.momentum).norm() < ulps<Q>(100) * m);
  CHECK(std::abs((before.energy - after.energy) / loss - 1) < 0.02);
  CHECK(std::abs((state_of(solver, 1).u[0] - state_of(solver, 0).u[0]) / relative - e) < 0.02 * e);
}

TEMPLATE_LIST_TEST_CASE("a block that slides on another is slowed by friction once, and pulls the other along", "",
                        Policies) {
  using Q = TestType;
  constexpr int dim = Q::dim, top = dim - 1;
  using X = Vec<dim, double>;
  double const mu = 0.3, g = 10;
  X low = X::Constant(-0.06), high = X::Constant(0.06);
  low[0] = -0.2, high[0] = 0.2, low[top] = 0, high[top] = 0.06;
  Box<dim> const lower{low, high},
      upper{X::Constant(-0.06) + 0.12 * X::Unit(top), X::Constant(0.06) + 0.12 * X::Unit(top)};
  Rigid<dim> a, b;
  a.properties = mass_properties(lower, 2000, dr), b.properties = mass_properties(upper, 2000, dr);
  a.given_velocity[top] = 0;
  for (auto& w : a.given_turning) w = 0;
  b.velocity[0] = 0.6;
  auto solver =
      solver_of_bodies<Free<Q, SymplecticEuler>>(dr, {.bodies = {a, b}, .contact = {.modulus = 1e7, .friction = mu}},
                                                 {g}, {fill_lattice(lower, dr), fill_lattice(upper, dr)});
  advance_to(solver, 0.03);
  auto const a0 = state_of(solver, 0), b0 = state_of(solver, 1);
  advance_to(solver, 0.09);
  auto const a1 = state_of(solver, 0), b1 = state_of(solver, 1);
  double const slowed = (b0.u[0] - b1.u[0]) / 0.06, pulled = (a1.u[0] - a0.u[0]) / 0.06;
  INFO("deceleration over mu g " << slowed / (mu * g) << ", forces over each other "
                                 << pulled * a.properties.mass / (slowed * b.properties.mass));
  CHECK(std::abs(slowed / (mu * g) - 1) < 0.02);
  CHECK(std::abs(pulled * a.properties.mass / (slowed * b.properties.mass) - 1) < ulps<Q>(1000));
}

TEMPLATE_LIST_TEST_CASE("balls that graze each other keep momentum and angular momentum", "", Policies) {
  using Q = TestType;
  constexpr int dim = Q::dim;
  using X = Vec<dim, double>;
  double const radius = 0.08;
  Ball<dim> const left{.centre = X::Zero(), .radius = radius},
      right{.centre = 2.4 * radius * X::Unit(0) * std::cos(0.3) + 2.4 * radius * X::Unit(dim - 1) * std::sin(0.3),
            .radius = radius};
  Rigid<dim> a, b;
  a.properties = mass_properties(left, 2000, dr), b.properties = mass_properties(right, 1000, dr);
  a.velocity[0] = 1, b.angular_velocity[0] = 3;
  auto solver =
      solver_of_bodies<Free<Q, SymplecticEuler>>(dr, {.bodies = {a, b}, .contact = {.modulus = 2e7, .friction = 0.6}},
                                                 {0}, {fill_lattice(left, dr), fill_lattice(right, dr)});
  auto const before = motion_of_all(solver);
  collide(solver);
  auto const after = motion_of_all(solver);
  INFO("change of momentum " << (after.momentum - before.momentum).norm() << " of " << before.momentum.norm()
                             << ", of angular momentum " << (after.about_origin - before.about_origin).norm() << " of "
                             << before.about_origin.norm() << ", energy kept " << after.energy / before.energy);
  CHECK((state_of(solver, 1).u - b.velocity).norm() > 0.1);
  CHECK((state_of(solver, 1).w - b.angular_velocity).norm() > 0.1);
  CHECK((after.momentum - before.momentum).norm() < ulps<Q>(100) * before.momentum.norm());
  // Angular momentum also changes by the error of the integrator, x_n x u_n+1, which is zero for equal forces; the
  // middle between two positions is rounded.
  CHECK((after.about_origin - before.about_origin).norm() < ulps<Q>(1000) * before.momentum.norm() * radius);
  CHECK(after.energy < before.energy);
}

}  // namespace scree::test::collision_tests
