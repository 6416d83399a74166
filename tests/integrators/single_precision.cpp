// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/integrators/velocity_verlet.hpp>
#include <scree/laws/hypoplastic.hpp>
#include <scree/motion/translation.hpp>
#include <scree/neighbours/cell_list.hpp>
#include <scree/solver/solver.hpp>

#include <support/bodies.hpp>
#include <support/policies.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <string>
#include <vector>

// Evolution in steps that are smaller than the last digit of the evolving value.
namespace scree::test::single_precision_tests {
using namespace fields;

struct GivenAcceleration {
  double a;
  using reads = Fields<>;
  using writes = Fields<Acceleration>;
  template <class I, class O>
  SCREE_FN void operator()(I const&, O& out) const {
    out[acceleration].setZero();
    out[acceleration][0] = static_cast<typename O::template type<Acceleration>::Scalar>(a);
  }
};

namespace {

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

struct Flight {
  double a = 0;
  using evolves = Fields<Velocity, Position>;
  auto stages(Resolution const&) const {
    return std::tuple(
        stage<Fields<Velocity, Position>>(std::tuple(point_pass<Material>("given", GivenAcceleration{a}))));
  }
  std::tuple<> limits(Resolution const&) const { return {}; }
};
template <class Real, class Integrator = Midpoint, class Motion = AtRest>
struct Flying : Formulation<2, Real> {
  using physics = Flight;
  using integrator = Integrator;
  using motion = Motion;
  template <class P>
  using search = CellList<P>;
};
using Schemes = std::tuple<Midpoint, SymplecticEuler, VelocityVerlet>;

template <class Real>
std::vector<Vec<2, Real>> row(double offset, double spacing, std::size_t number) {
  std::vector<Vec<2, Real>> points;
  for (std::size_t k = 0; k < number; ++k) points.push_back({Real(offset), Real(offset + double(k) * spacing)});
  return points;
}
/// A field with its remainder, of all particles, along the first axis.
template <class S, Field F>
std::vector<double> whole(S const& solver, F field) {
  auto const value = solver.material().to_host(field), rest = solver.material().to_host(Remainder<F>{});
  std::vector<double> all;
  for (std::size_t k = 0; k < value.size(); ++k) all.push_back(double(value[k][0]) + double(rest[k][0]));
  return all;
}
constexpr double dt = 1.0 / (1 << 20);

/// The message of a solver of particles in float or double at an offset, made and advanced by a step; "" without one.
template <class Real>
std::string complaint(double offset, double spacing, bool of_wall = false, bool checks = true) {
  auto const far = row<Real>(offset, spacing, 4), near = row<Real>(0, spacing, 4);
  try {
    Solver<Flying<Real>> solver({.spacing = spacing, .start_checks = checks}, of_wall ? near : far,
                                of_wall ? far : std::vector<Vec<2, Real>>{});
    solver.step(dt);
  } catch (std::invalid_argument const& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("in float particles go the whole way at any speed, however far from the origin", "", Schemes) {
  int const steps = 3000;
  for (double const offset : {0.0, 1.0, 100.0, 1e4}) {
    double const spacing = std::max(1e-3, 1e-3 * offset), unit = std::ldexp(1.0, std::ilogb(offset + spacing) - 23);
    // Ways in each step, in units in the last place of the position.
    std::vector<double> const speeds{1e-3, 0.1, 0.3, 0.49, 0.51, 0.7, 1.3, 7.6, 300, -0.1, -0.49, -0.7, -1.4};
    auto const start = row<float>(offset, spacing, speeds.size());
    Solver<Flying<float, TestType>> solver({.spacing = spacing}, start);
    std::vector<Vec<2, float>> u;
    for (double const each : speeds) u.push_back({float(each * unit / dt), 0});
    auto next = u.begin();
    solver.set(velocity, [&](auto const&) { return *next++; });
    for (int k = 0; k < steps; ++k) solver.step(dt);
    auto const x = whole(solver, position);
    for (std::size_t k = 0; k < u.size(); ++k) {
      double const way = steps * dt * double(u[k][0]);
      INFO("offset " << offset << " m, " << speeds[k] << " units a step, moved " << (x[k] - double(start[k][0])) / way);
      CHECK(std::abs(x[k] - double(start[k][0]) - way) < 1e-4 * std::abs(way));
      double const rounded = double(solver.material().to_host(position)[k][0]);
      CHECK(std::abs(rounded - x[k]) <= std::abs(rounded) * std::ldexp(1.0, -24));
    }
  }
}

TEMPLATE_LIST_TEST_CASE("in float fast particles feel small accelerations", "", Schemes) {
  int const steps = 3000;
  for (double const a : {-9.81, 0.01}) {
    Solver<Flying<float, TestType>> solver({.spacing = 1, .physics = {a}}, row<float>(0, 1, 2));
    std::vector<Vec<2, float>> const u{{-9, 0}, {1, 0}};
    auto next = u.begin();
    solver.set(velocity, [&](auto const&) { return *next++; });
    for (int k = 0; k < steps; ++k) solver.step(dt);
    auto const now = whole(solver, velocity);
    for (std::size_t k = 0; k < u.size(); ++k) {
      double const gained = now[k] - double(u[k][0]);
      INFO(a << " m/s^2 at " << u[k][0] << " m/s: " << gained / (a * steps * dt));
      CHECK(std::abs(gained - a * steps * dt) < 1e-4 * std::abs(a) * steps * dt);
    }
  }
}

TEMPLATE_TEST_CASE("in float slow rates add up", "", Concentration, Density, VoidRatio) {
  using P = Policy<2, float, Kokkos::DefaultHostExecutionSpace>;
  using F = TestType;
  int const steps = 3000;
  float const start = 0.5f;
  for (float const units : {0.01f, 0.49f, 0.7f, -0.2f}) {  // in the last place of 0.5, in each step
    auto body = body_of<P, F, typename F::rate, Previous<F>, Remainder<F>>({{0, 0}}, 1);
    float const change = units * std::ldexp(1.0f, -24), rate = change / float(dt);
    body.fill(F{}, start), body.fill(typename F::rate{}, rate);
    for (int k = 0; k < steps; ++k) {
      for_each_particle<P>("predict", body, Midpoint::predictor<P>(Fields<F>{}, dt));
      for_each_particle<P>("correct", body, Midpoint::corrector<P>(Fields<F>{}, dt));
    }
    double const now = double(body.to_host(F{})[0]) + double(body.to_host(Remainder<F>{})[0]);
    INFO(units << " units a step: " << (now - start) / (steps * double(change)));
    CHECK(std::abs(now - start - steps * double(change)) < 1e-4 * std::abs(steps * double(change)));
  }
}

TEST_CASE("in float particles that pass a period hundreds of times lose nothing of their way") {
  int const steps = 3000;
  double const speeds[] = {0.137, -0.137, 1.77, -0.731};  // sixteenths of a period in each step
  std::vector<Vec<2, float>> u;
  for (double const each : speeds) u.push_back({float(each / 16 / dt), 0});
  Solver<Flying<float>> solver({.spacing = 0.0625, .periods = {{0, 0, 1}}, .start_checks = false},
                               row<float>(0.3, 0.0625, 4));
  auto next = u.begin();
  solver.set(velocity, [&](auto const&) { return *next++; });
  for (int k = 0; k < steps; ++k) solver.step(dt);
  auto const x = whole(solver, position);
  for (std::size_t k = 0; k < u.size(); ++k) {
    double const way = double(0.3f) + steps * dt * double(u[k][0]), exact = way - std::floor(way);
    double const off = std::abs(x[k] - exact);
    INFO("particle " << k << " at " << x[k] << " instead of " << exact << ", " << way << " periods");
    CHECK(std::min(off, 1 - off) < steps * std::ldexp(1.0, -47));
  }
}

TEST_CASE("in float a run that goes on from a snapshot has the same bits, remainders too") {
  auto const start = row<float>(1, 1e-3, 5);
  auto const made = [&] {
    Solver<Flying<float>> solver({.spacing = 1e-3, .physics = {0.3}}, start);
    solver.set(velocity, [](auto const& x) { return Vec<2, float>(0.01f * x[1], 0.02f); });
    return solver;
  };
  auto whole_run = made(), first = made(), second = made();
  for (int k = 0; k < 400; ++k) whole_run.step(dt);
  for (int k = 0; k < 150; ++k) first.step(dt);
  Snapshot const middle = first.snapshot();
  REQUIRE(middle.find("material/remainder of position") != nullptr);
  CHECK(middle.find("material/remainder of position")->bytes !=
        made().snapshot().find("material/remainder of position")->bytes);
  second.restore(middle);
  for (int k = 0; k < 250; ++k) second.step(dt);
  CHECK(second.snapshot() == whole_run.snapshot());

  second.set(position, [](auto const& x) { return x; });
  for (auto const& rest : second.material().to_host(Remainder<Position>{})) CHECK(rest == Vec<2, float>(0, 0));
}

TEST_CASE("in double nothing has a remainder") {
  STATIC_CHECK_FALSE(OneOf<Remainder<Position>, material_fields<Flying<double>>>);
  STATIC_CHECK(OneOf<Remainder<Position>, material_fields<Flying<float>>>);
  STATIC_CHECK(OneOf<Remainder<Velocity>, material_fields<Flying<float, VelocityVerlet>>>);
  STATIC_CHECK_FALSE(OneOf<Remainder<Position>, wall_fields<Flying<float>>>);
}

TEST_CASE("positions that float cannot resolve are refused, with the largest coordinate, the spacing and what to do") {
  for (double const offset : {0.0, 1.0, 4.0, -8.0}) CHECK(complaint<float>(offset, 1e-3) == "");
  CHECK(complaint<float>(100, 0.1) == "");
  CHECK(complaint<float>(1e4, 10) == "");
  for (bool const of_wall : {false, true})
    for (double const offset : {10.0, 100.0, -100.0, 1e4}) {
      INFO("offset " << offset << ", wall " << of_wall);
      auto const said = complaint<float>(offset, 1e-3, of_wall);
      CHECK_THAT(said, ContainsSubstring("single precision is too coarse") &&
                           ContainsSubstring("the largest coordinate is 1") &&
                           ContainsSubstring("0.001 m: coordinates may be up to 8.389 m") &&
                           ContainsSubstring("move the origin") && ContainsSubstring("double precision"));
      CHECK(complaint<float>(offset, 1e-3, of_wall, false) == "");
      CHECK(complaint<double>(offset, 1e-3, of_wall) == "");
    }
}

TEST_CASE("a wall that travels beyond what float resolves stops the run") {
  using F = Flying<float, Midpoint, Translation<2>>;
  Solver<F> solver({.spacing = 1e-3, .motion = {.speed = {1, 0}}}, row<float>(0, 1e-3, 4), row<float>(0.1, 1e-3, 4));
  for (int k = 0; k < 8; ++k) solver.step(1);
  CHECK_THROWS_MATCHES(solver.run(600), OutsideValidity, MessageMatches(ContainsSubstring("too coarse")));
}

}  // namespace scree::test::single_precision_tests
