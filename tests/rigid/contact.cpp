// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/integrators/velocity_verlet.hpp>

#include <support/rigid_bodies.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

// Contact of rigid bodies with walls.
namespace scree::test::contact_tests {
using namespace fields;
namespace {

constexpr double dr = 0.02, g = 10;
template <int Dim>
Vec<Dim, double> up(double height) {
  return height * Vec<Dim, double>::Unit(Dim - 1);
}
template <int Dim>
RigidBodies<Dim> one(Rigid<Dim> const& body, RigidContact const& contact) {
  return {.bodies = {body}, .contact = contact};
}
/// A ball that falls on a floor.
template <class F>
Solver<F> dropped(double restitution, double height) {
  constexpr int dim = F::dim;
  double const radius = 0.1;
  Ball<dim> const ball{.centre = up<dim>(radius + height), .radius = radius};
  Rigid<dim> body;
  body.properties = mass_properties(ball, 2000, dr);
  return solver_of_bodies<F>(dr, one<dim>(body, {.modulus = 5e7, .restitution = restitution}), {g},
                             {fill_lattice(ball, dr)}, floor_of<dim>(0.16, dr));
}
/// The speed with which a body leaves the floor over that of its arrival, and the largest overlap.
template <class S>
std::pair<double, double> rebound(S& solver) {
  constexpr int top = S::policy::dim - 1;
  double arrives = 0, deepest = 0;
  for (int k = 0; k < 100000; ++k) {
    solver.step(1e-3);
    auto const now = state_of(solver);
    arrives = std::min(arrives, now.u[top]);
    for (auto const d : solver.template body<Block>().to_host(contact_overlap)) deepest = std::max(deepest, double(d));
    if (now.u[top] > 0 && now.force.norm() == 0) return {now.u[top] / -arrives, deepest};
  }
  return {0, deepest};
}
}  // namespace

TEMPLATE_LIST_TEST_CASE("a ball that falls on a floor returns with the restitution that is set", "", Policies) {
  using Q = TestType;
  auto const check = [](auto solver, double e) {
    auto const [ratio, overlap] = rebound(solver);
    INFO("restitution " << e << ": rises to " << ratio * ratio / (e * e) << " e^2 h, overlap " << overlap / dr);
    CHECK(std::abs(ratio * ratio - e * e) < 0.04 * e * e);
    CHECK(overlap < 0.5 * dr);
    CHECK(std::abs(state_of(solver).w.norm()) < 0.05);
  };
  check(dropped<Free<Q, SymplecticEuler>>(0.5, 0.1), 0.5);
  check(dropped<Free<Q, SymplecticEuler>>(0.9, 0.1), 0.9);
  if constexpr (Q::dim == 2)
    check(dropped<Free<Q>>(0.7, 0.1), 0.7), check(dropped<Free<Q, VelocityVerlet>>(0.7, 0.1), 0.7);
}

namespace {
/// A block on a slope: everything is turned by the angle, gravity is not.
template <class F>
Solver<F> on_slope(double angle, double friction) {
  constexpr int dim = F::dim;
  using X = Vec<dim, double>;
  X low = X::Constant(-0.1), high = X::Constant(0.1);
  low[dim - 1] = 0, high[dim - 1] = 0.1;
  auto const turned = [&](Points<dim> points) {
    for (X& x : points) {
      double const a = x[0], b = x[dim - 1];
      x[0] = a * std::cos(angle) + b * std::sin(angle), x[dim - 1] = b * std::cos(angle) - a * std::sin(angle);
    }
    return points;
  };
  Box<dim> const block{low, high};
  Rigid<dim> body;
  body.properties = mass_properties(block, 2000, dr);
  body.properties.centre = turned({body.properties.centre})[0];
  if constexpr (dim == 3) {
    Mat<3, double> R = Mat<3, double>::Identity();
    R(0, 0) = R(2, 2) = std::cos(angle), R(0, 2) = std::sin(angle), R(2, 0) = -std::sin(angle);
    body.properties.inertia = (R * body.properties.inertia * transposed(R)).eval();
  }
  X left = X::Constant(-0.2), right = X::Constant(0.2);
  left[dim - 1] = -3 * dr, right[dim - 1] = 0, right[0] = 0.5;
  return solver_of_bodies<F>(dr, one<dim>(body, {.modulus = 1e6, .friction = friction}), {g},
                             {turned(fill_lattice(block, dr))}, turned(fill_lattice(Box<dim>{left, right}, dr)));
}
}  // namespace

TEMPLATE_LIST_TEST_CASE("a block on a slope sticks below the angle of friction and slides above it", "", Policies) {
  using Q = TestType;
  using F = Free<Q, SymplecticEuler>;
  double const mu = 0.4, below = std::atan(mu) - 0.05, above = std::atan(mu) + 0.15;
  auto const speed_along = [](auto const& state, double angle) {
    return state.u[0] * std::cos(angle) - state.u[Q::dim - 1] * std::sin(angle);
  };
  auto sticks = on_slope<F>(below, mu);
  advance_to(sticks, 0.3);
  auto const first = state_of(sticks);
  advance_to(sticks, 0.8);
  auto const second = state_of(sticks);
  double const crept = (second.x - first.x).norm() / 0.5;
  INFO("creeps by " << crept << " m/s, turned by " << (second.q - first.q).norm());
  CHECK(crept < 1e-6);
  CHECK((second.q - first.q).norm() < 1e-5);

  auto slides = on_slope<F>(above, mu);
  advance_to(slides, 0.1);
  double const u0 = speed_along(state_of(slides), above);
  advance_to(slides, 0.3);
  double const u1 = speed_along(state_of(slides), above);
  double const exact = g * (std::sin(above) - mu * std::cos(above)), found = (u1 - u0) / 0.2;
  INFO("acceleration over exact " << found / exact);
  CHECK(std::abs(found / exact - 1) < 0.03);
}

}  // namespace scree::test::contact_tests
