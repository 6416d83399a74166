// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <support/formulations.hpp>

#include <scree/granular/segregating.hpp>
#include <scree/segregation/shear_rate_closure.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

namespace scree::test {
namespace {

using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
using Mechanics = Granular<MuOfI<BidisperseGrains>, LinearFilter, NoVolumeControl, AdamiWalls>;
using Physics = SegregatingGranular<Mechanics, ConservativeSegregation<ShearRateClosure>>;
using Sorting = Formulated<OnHost, Physics>;

/// A layer that flows down a slope of 30 degrees, periodic along it, with grains that change places fast.
/// `feedback`: the mechanics knows both sizes.
Solver<Sorting> flowing(int period, bool feedback, double faster = 1) {
  Physics physics;
  double const small = 0.05, large = 0.2;
  physics.mechanics.law = {.elastic = {1e5, 0.3, 1500}, .grains = {feedback ? small : large, large}};
  physics.mechanics.gravity = {9.81, 0.52};
  physics.segregation.closure = {.chi_V = 0.5 * faster, .chi_D = 0.05, .d_small = small, .d_large = large};
  physics.period = period;
  auto solver = solver_of<Sorting>(layer({1, 0.6}, 0.1), 0.1, physics, {}, {{0, 0, 1}});
  solver.set(stress, [](auto const& x) {
    double const p = 1500 * 9.81 * std::cos(0.52) * (0.6 - x[1]);
    return Vec<4, double>(-p, -p, -p, 0.3 * p);
  });
  solver.set(velocity, [](auto const& x) { return Vec<2, double>(x[1], 0); });
  solver.set(concentration, [](auto const& x) { return 0.5 + 0.4 * std::sin(6 * x[0]) * std::cos(5 * x[1]); });
  return solver;
}
Solver<Sorting>& stepped(Solver<Sorting>& solver, long until) {
  while (solver.steps() < until) solver.step(1);
  return solver;
}
/// sum V C.
double content_of(Solver<Sorting> const& solver) {
  auto const C = concentrations_of(solver);
  auto const V = solver.material().to_host(volume);
  double sum = 0;
  for (std::size_t i = 0; i < C.size(); ++i) sum += V[i] * C[i];
  return sum;
}
double difference(std::vector<double> a, std::vector<double> const& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return largest_of(a);
}
double mean_velocity(Solver<Sorting> const& solver) {
  double sum = 0;
  for (auto const& u : solver.material().to_host(velocity)) sum += u[0];
  return sum / solver.material().size();
}

}  // namespace

TEST_CASE("segregation in a flow neither makes nor destroys grains, at any interval") {
  for (int const period : {1, 7}) {
    INFO("period " << period);
    auto solver = flowing(period, true);
    auto const start = concentrations_of(solver);
    double const content = content_of(solver);
    double outside = 0;
    while (solver.steps() < 400) {
      solver.step(1);
      outside = std::max(outside, outside_of_range(concentrations_of(solver)));
    }
    CHECK(std::abs(content_of(solver) / content - 1) < 1e-13);
    CHECK(outside == 0);
    CHECK(difference(concentrations_of(solver), start) > 0.1);  // it does happen,
    CHECK(mean_velocity(solver) > 0.5);                         // and so does the flow
  }
}

TEST_CASE("the concentration changes the strength of the flowing material") {
  // Small grains have a lower inertial number, and less friction.
  auto of_large = flowing(1, true), of_small = flowing(1, true), without = flowing(1, false);
  of_large.set(concentration, [](auto const&) { return 0.0; });
  of_small.set(concentration, [](auto const&) { return 1.0; });
  without.set(concentration, [](auto const&) { return 1.0; });
  double const large = mean_velocity(stepped(of_large, 150)), small = mean_velocity(stepped(of_small, 150));
  INFO("mean velocities " << large << " and " << small << " m/s");
  CHECK(small > 1.05 * large);
  CHECK(mean_velocity(stepped(without, 150)) == large);
}

TEST_CASE("a longer interval of the segregation is a longer step of first order") {
  // The rate at the middle of one step holds for n: the error is (n - 1) dt/2 times its change. Without feedback the
  // motion is the same in all runs. 180 steps are whole intervals of 5 and of 9.
  auto at_every = flowing(1, false, 0.3), at_fifth = flowing(5, false, 0.3), at_ninth = flowing(9, false, 0.3);
  auto const exact = concentrations_of(stepped(at_every, 180));
  double const five = difference(concentrations_of(stepped(at_fifth, 180)), exact);
  double const nine = difference(concentrations_of(stepped(at_ninth, 180)), exact);
  CHECK((at_every.material().to_host(position) == at_ninth.material().to_host(position)));
  INFO("differences " << five << " and " << nine);
  CHECK(five > 1e-5);
  CHECK(std::abs(nine / five - 2) < 0.1);
}

TEST_CASE("the limits of the segregation are divided by the interval") {
  auto at_every = flowing(1, true, 1e5), at_seventh = flowing(7, true, 1e5);
  // Steps are evened out over 1000 s: a change of 1e-3 of a step at most.
  double const short_step = at_seventh.step(1000), long_step = at_every.step(1000);
  CHECK(at_seventh.limits() == std::map<std::string, long>{{"segregation", 1}});
  CHECK(at_every.limits() == std::map<std::string, long>{{"segregation", 1}});
  CHECK(std::abs(long_step / short_step - 7) < 1e-3);
  CHECK(flowing(7, true).step(1000) == flowing(1, true).step(1000));  // that of the mechanics
}

}  // namespace scree::test
