// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/integrators/velocity_verlet.hpp>

#include <support/rigid_bodies.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <numbers>

// Springs and dashpots of rigid bodies.
namespace scree::test::springs_tests {
namespace {

template <class Q>
using Sprung = Free<Q, VelocityVerlet>;
template <int Dim>
Rigid<Dim> body_at(Vec<Dim, double> const& x) {
  Rigid<Dim> body;
  body.properties.mass = 2;
  body.properties.centre = x;
  body.properties.inertia = 0.5 * Inertia<Dim>::Identity();
  return body;
}
template <class F>
Solver<F> solver_with(RigidBodies<F::dim> const& rigid, double gravity = 0) {
  std::vector<Points<F::dim>> particles;
  for (auto const& body : rigid.bodies) particles.push_back({body.properties.centre});
  return solver_of_bodies<F>(0.1, rigid, {gravity}, particles);
}
/// The times between which a quantity crosses zero upwards for the first and the last of some times, per period, and
/// the ratio of its maxima in the last and the first period.
struct Oscillation {
  double period = 0, decay = 0;
};
template <class S, class Quantity>
Oscillation oscillation(S& solver, double step, int periods, Quantity const& quantity) {
  double before = quantity(solver), first = -1, last = 0, top = 0, first_top = 0;
  for (int crossings = -1; crossings < periods;) {
    solver.step(step);
    double const now = quantity(solver);
    top = std::max(top, now);
    if (before < 0 && now >= 0) {
      last = solver.time() - step * now / (now - before);
      if (crossings++ == -1) first = last, top = 0;
      if (crossings == 1) first_top = top;
      if (crossings < periods) top = 0;
    }
    before = now;
  }
  return {(last - first) / periods, top / first_top};
}
}  // namespace

TEMPLATE_LIST_TEST_CASE("a body on a spring oscillates with the exact period and decay", "", DoublePolicies) {
  using std::numbers::pi;
  using Q = TestType;
  using X = Vec<Q::dim, double>;
  double const k = 800, m = 2, w = std::sqrt(k / m);
  auto const along = [](auto const& solver) { return state_of(solver).x[0] - 0.5; };
  auto body = body_at<Q::dim>(0.5 * X::Unit(0));
  body.velocity[0] = 0.3;
  Spring<Q::dim> const spring{.point = body.properties.centre, .stiffness = k};
  auto free = solver_with<Sprung<Q>>({.bodies = {body}, .springs = {spring}});
  auto const found = oscillation(free, 1e-3, 10, along);
  INFO("period over exact " << found.period * w / (2 * pi) << ", ratio of amplitudes " << found.decay);
  CHECK(std::abs(found.period * w / (2 * pi) - 1) < 1e-4);
  CHECK(std::abs(found.decay - 1) < 1e-4);
  double const energy = m * sq(state_of(free).u[0]) / 2 + k * sq(along(free)) / 2;
  CHECK(std::abs(energy / (m * 0.09 / 2) - 1) < 1e-3);

  double const c = 4, rate = c / (2 * m), damped = std::sqrt(w * w - rate * rate);
  auto dashpot = spring;
  dashpot.damping = c;
  auto slow = solver_with<Sprung<Q>>({.bodies = {body}, .springs = {dashpot}});
  auto const decays = oscillation(slow, 1e-4, 10, along);
  double const exact = std::exp(-rate * 9 * 2 * pi / damped);
  INFO("damped: period over exact " << decays.period * damped / (2 * pi) << ", decay over exact "
                                    << decays.decay / exact);
  CHECK(std::abs(decays.period * damped / (2 * pi) - 1) < 1e-4);
  CHECK(std::abs(decays.decay / exact - 1) < 2e-3);
}

TEMPLATE_LIST_TEST_CASE("a body that hangs off its centre on a spring oscillates like a pendulum", "", DoublePolicies) {
  using std::numbers::pi;
  using Q = TestType;
  using X = Vec<Q::dim, double>;
  constexpr int top = Q::dim - 1;
  // A stiff spring of length zero is a hinge at a distance of 0.4 m above the centre.
  double const l = 0.4, g = 10, m = 2, I = 0.5, w = std::sqrt(m * g * l / (I + m * l * l));
  auto body = body_at<Q::dim>(X::Zero());
  body.velocity[0] = -0.02 * l, body.angular_velocity[Q::dim == 2 ? 0 : 1] = Q::dim == 2 ? -0.02 : 0.02;
  Spring<Q::dim> const hinge{.point = l * X::Unit(top), .anchor = l * X::Unit(top), .stiffness = 2e6, .length = 0.0};
  auto solver = solver_with<Sprung<Q>>({.bodies = {body}, .springs = {hinge}}, g);
  auto const found = oscillation(solver, 1e-4, 2, [](auto const& now) { return state_of(now).x[0]; });
  INFO("period over exact " << found.period * w / (2 * pi));
  CHECK(std::abs(found.period * w / (2 * pi) - 1) < 1e-3);
}

TEMPLATE_LIST_TEST_CASE("two bodies with springs between them keep momentum and angular momentum", "", DoublePolicies) {
  using std::numbers::pi;
  using Q = TestType;
  constexpr int dim = Q::dim;
  using X = Vec<dim, double>;
  double const k = 300, torsion = 40;
  auto a = body_at<dim>(X::Zero()), b = body_at<dim>(X::Unit(0));
  a.velocity[0] = 0.2, b.velocity[0] = -0.2, b.angular_velocity[0] = 0.5, a.angular_velocity[0] = -0.5;
  Spring<dim> const spring{.body = 1, .point = X::Unit(0), .other = 0, .stiffness = k, .torsion = torsion};
  auto straight = solver_with<Sprung<Q>>({.bodies = {a, b}, .springs = {spring}});
  // Reduced mass 1 kg and reduced moment of inertia 0.25 kg m^2.
  auto const way =
      oscillation(straight, 1e-3, 5, [](auto const& now) { return 1 - state_of(now, 1).x[0] + state_of(now).x[0]; });
  INFO("period over exact " << way.period * std::sqrt(k) / (2 * pi));
  CHECK(std::abs(way.period * std::sqrt(k) / (2 * pi) - 1) < 1e-3);
  auto turning = solver_with<Sprung<Q>>({.bodies = {a, b}, .springs = {spring}});
  auto const twist = oscillation(turning, 1e-3, 5, [](auto const& now) { return state_of(now, 1).w[0]; });
  INFO("period of torsion over exact " << twist.period * std::sqrt(torsion / 0.25) / (2 * pi));
  CHECK(std::abs(twist.period * std::sqrt(torsion / 0.25) / (2 * pi) - 1) < 1e-3);

  // Off-centre, with dashpots.
  Spring<dim> skew{.body = 0,
                   .point = 0.2 * X::Unit(dim - 1),
                   .other = 1,
                   .anchor = X::Unit(0) - 0.1 * X::Unit(dim - 1),
                   .stiffness = k,
                   .damping = 3,
                   .torsion = torsion,
                   .torsion_damping = 1};
  a.velocity[dim - 1] = 0.7;
  auto solver = solver_with<Sprung<Q>>({.bodies = {a, b}, .springs = {skew}});
  auto const sums = [&] {
    auto const first = state_of(solver, 0), second = state_of(solver, 1);
    return std::pair(
        X(2.0 * first.u + 2.0 * second.u),
        Turn<dim>(first.L + second.L + moment_of(first.x, X(2.0 * first.u)) + moment_of(second.x, X(2.0 * second.u))));
  };
  auto const before = sums();
  for (int step = 0; step < 500; ++step) solver.step(1e-3);
  auto const after = sums();
  INFO("change of momentum " << (after.first - before.first).norm() << ", of angular momentum "
                             << (after.second - before.second).norm());
  CHECK((after.first - before.first).norm() < 1e-13);
  CHECK((after.second - before.second).norm() < 1e-12);
  CHECK((state_of(solver, 1).L - sums().second).norm() > 1e-3);
}

}  // namespace scree::test::springs_tests
