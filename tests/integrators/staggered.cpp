// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "pendulum.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <array>

namespace scree::test::staggered_tests {
namespace {

constexpr double speed = 1.2, end = 4;  // swings to 1.287 rad, a period lasts 7.06 s

struct Reference {
  static PendulumState const& get() {
    // Error of the scheme at this step: 1e-9.
    static PendulumState const state = [] {
      auto solver = pendulum<Midpoint>(1e-4, speed);
      solver.run(end);
      return state_of(solver);
    }();
    return state;
  }
};

/// Errors of x, u and C at the end.
template <class Integrator>
std::array<double, 3> errors(double step) {
  auto solver = pendulum<Integrator>(step, speed);
  solver.run(end);
  auto const found = state_of(solver);
  auto const& exact = Reference::get();
  return {std::abs(found.x - exact.x), std::abs(found.u - exact.u), std::abs(found.C - exact.C)};
}

template <class Integrator, int Order>
struct Scheme {
  using integrator = Integrator;
  static constexpr int order = Order;
};
using Schemes = std::tuple<Scheme<Midpoint, 2>, Scheme<SymplecticEuler, 1>, Scheme<VelocityVerlet, 2>>;

/// Largest deviation of the energy u^2/2 + C^2/2 from its start, relative to it, over the first and over the last
/// twentieth of 200 periods of the linear system.
template <class Integrator>
std::array<double, 2> energy_errors(double step) {
  auto solver = pendulum<Integrator>(step, 1, true);
  double const run = 200 * 2 * 3.14159265;
  std::array<double, 2> worst{0, 0};
  while (solver.time() < run) {
    solver.step(step);
    auto const state = state_of(solver);
    double const error = std::abs(sq(state.u) + sq(state.C) - 1);
    if (solver.time() < run / 20) worst[0] = std::max(worst[0], error);
    if (solver.time() > run - run / 20) worst[1] = std::max(worst[1], error);
  }
  return worst;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("integrators have their order on a pendulum in rate form", "", Schemes) {
  auto const coarse = errors<typename TestType::integrator>(0.02), fine = errors<typename TestType::integrator>(0.01);
  for (std::size_t k = 0; k < 3; ++k) {
    double const order = std::log2(coarse[k] / fine[k]);
    INFO("field " << k << ": errors " << coarse[k] << " and " << fine[k] << ", order " << order);
    CHECK(std::abs(order - TestType::order) < 0.15);
  }
}

TEST_CASE("staggered schemes bound the energy of an oscillation, the midpoint scheme does not") {
  auto const euler = energy_errors<SymplecticEuler>(0.1), verlet = energy_errors<VelocityVerlet>(0.1);
  auto const midpoint = energy_errors<Midpoint>(0.1);
  WARN("energy, first and last 10 of 200 periods of 63 steps: symplectic Euler "
       << euler[0] << " " << euler[1] << ", velocity Verlet " << verlet[0] << " " << verlet[1] << ", midpoint "
       << midpoint[0] << " " << midpoint[1]);
  CHECK(euler[1] < 1.1 * euler[0]);
  CHECK(euler[0] < 0.06);
  CHECK(verlet[1] < 1.1 * verlet[0]);
  CHECK(verlet[0] < 0.003);
  // |1 + i z - z^2/2|^2 = 1 + z^4/4 per step of z = omega dt.
  CHECK(std::abs(midpoint[1] - (std::pow(1 + 0.1 * 0.1 * 0.1 * 0.1 / 4, 200 * 2 * 31.4159265) - 1)) < 0.01);
}

TEST_CASE("a step of symplectic Euler takes rate law, velocity and position one after the other") {
  auto solver = pendulum<SymplecticEuler>(0.5, 2);
  solver.step(0.5);
  // C = 0 + 0.5 cos(0) 2, u = 2 - 0.5 C, x = 0.5 u; exact in binary fractions.
  auto const state = state_of(solver);
  CHECK(state.C == 1);
  CHECK(state.u == 1.5);
  CHECK(state.x == 0.75);
}

TEST_CASE("a step of velocity Verlet takes the rate law half way of the drift") {
  auto solver = pendulum<VelocityVerlet>(0.5, 2);
  solver.step(0.5);
  auto const state = state_of(solver);
  // a = 0 at first: x = 0.5 half way, C = 0.5 cos(0.5) 2, u = 2 - 0.25 C, x = 1.
  CHECK(std::abs(state.C - std::cos(0.5)) < 1e-15);
  CHECK(std::abs(state.u - (2 - std::cos(0.5) / 4)) < 1e-15);
  CHECK(state.x == 1);
}

}  // namespace scree::test::staggered_tests
