// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <support/formulations.hpp>

#include <scree/granular/segregating.hpp>
#include <scree/openings/regions.hpp>
#include <scree/segregation/constant_closure.hpp>
#include <scree/segregation/hybrid.hpp>
#include <scree/segregation/shear_rate_closure.hpp>
#include <scree/segregation/under_gravity.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <numbers>

namespace scree::test::segregating_tests {
using namespace fields;
namespace {

using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
struct Unfiltered : GranularModels {
  using filter = NoFilter;
};
struct Models : GranularModels {
  using law = MuOfI<BidisperseGrains>;
};
using Mechanics = Granular<Models>;
using Physics = SegregatingGranular<Mechanics, ConservativeSegregation<ShearRateClosure>>;
using Sorting = Formulated<OnHost, Physics>;

/// A layer that flows down a slope of 30 degrees, periodic along it, with fast segregation. `feedback`: the mechanics
/// uses both grain sizes.
Solver<Sorting> flowing(int period, bool feedback, double faster = 1) {
  Physics physics;
  double const small = 0.05, large = 0.2;
  physics.mechanics.law = {.elastic = {1e5, 0.3, 1500}, .grains = {feedback ? small : large, large}};
  physics.mechanics.gravity = {9.81, 0.52};
  physics.transport.closure = {.chi_V = 0.5 * faster, .chi_D = 0.05, .d_small = small, .d_large = large};
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

/// d/dt of sum V C x of a block without walls, evenly mixed, under a gravity of the mechanics.
template <class Q, template <class> class Segregation>
Vec<Q::dim, double> drift_of_small_grains(Gravity const& gravity) {
  using Both = SegregatingGranular<Granular<Unfiltered>, Segregation<ConstantClosure>>;
  double const dr = 0.125;
  Both physics;
  physics.mechanics.law = {.elastic = {1e5, 0.3, 1500}, .grains = {0.01}};
  physics.mechanics.gravity = gravity;
  physics.transport.closure = {.velocity = 0.2, .diffusivity = 0.01};
  auto solver = solver_of<Formulated<Q, Both>>({lattice<Q::dim>(dr), {}}, dr, physics);
  set_field(solver, concentration, [](auto const&) { return 0.5; });
  auto const rates = rates_of(solver);
  auto const x = solver.material().to_host(position);
  Vec<Q::dim, double> sum = Vec<Q::dim, double>::Zero();
  for (std::size_t i = 0; i < x.size(); ++i) sum += std::pow(dr, Q::dim) * rates[i] * x[i];
  return sum;
}
template <class Q, template <class> class Segregation>
void expect_drift_along_gravity() {
  // Level, inclined, along the first coordinate, upwards, and inclined the other way.
  for (double const inclination : {0.0, 0.52, std::numbers::pi / 2, 2.5, -1.0}) {
    Gravity const gravity{9.81, inclination};
    auto const down = gravity.vector<Vec<Q::dim, double>>().normalized().eval();
    auto const drift = drift_of_small_grains<Q, Segregation>(gravity);
    INFO("inclination " << inclination << ", drift " << drift.transpose() << ", gravity " << down.transpose());
    // A cube is the same along all axes, so boundaries change only the magnitude. V F = 0.05 in a volume of one, less
    // the contribution that the outer rows of eight lack.
    CHECK((drift - drift.norm() * down).norm() < 1e-12 * drift.norm());
    CHECK(std::abs(drift.norm() / 0.05 - 1) < 0.3);
  }
  CHECK(drift_of_small_grains<Q, Segregation>({0, 0.52}).norm() == 0);  // no gravity, no segregation
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
    CHECK(difference(concentrations_of(solver), start) > 0.1);  // grains segregate,
    CHECK(mean_velocity(solver) > 0.5);                         // and the layer flows
  }
}

// Rates that are kept from one transport to the next are of the particles and concentrations at that time.
TEST_CASE("particles removed and values set between two transports neither make nor destroy grains") {
  for (int const period : {1, 10, 50}) {
    CAPTURE(period);
    auto solver = flowing(period, true);
    stepped(solver, 3);
    auto const before = content_of(solver);
    double removed = 0;
    for (auto const& each : solver.remove(Within<2>{{0, 0.35}, {1.1, 2}}, Fields<Volume, Concentration>{}))
      removed += each[volume] * each[concentration];
    REQUIRE(removed > 0.1 * before);
    CHECK(std::abs(content_of(stepped(solver, 23)) + removed - before) < 1e-12 * before);
    solver.set(concentration, [](auto const& x) { return x[0] < 0.5 ? 0.0 : 1.0; });
    auto const given = content_of(solver);
    stepped(solver, 43);
    CHECK(std::abs(content_of(solver) - given) < 1e-12 * given);
    for (double const C : concentrations_of(solver)) CHECK((C > -1e-6 && C < 1 + 1e-6));
  }
}

TEST_CASE("small grains go where the gravity of the mechanics points") {
  using InSpace = Policy<3, double, Kokkos::DefaultHostExecutionSpace>;
  expect_drift_along_gravity<OnHost, ConservativeSegregation>();
  expect_drift_along_gravity<InSpace, ConservativeSegregation>();
  expect_drift_along_gravity<OnHost, HybridSegregation>();
  expect_drift_along_gravity<InSpace, HybridSegregation>();
}

TEST_CASE("without mechanics gravity is given, or acts against the last coordinate") {
  using Alone = ConservativeSegregation<ConstantClosure>;
  using Under = UnderGravity<Alone>;
  Alone const segregation{{.velocity = 2, .diffusivity = 0.03}};
  auto const rates_with = [](auto const& physics) {
    using Model = std::remove_cvref_t<decltype(physics)>;
    auto solver = solver_of<Formulated<OnHost, Model>>(layer({1, 0.6}, 0.1), 0.1, physics);
    set_field(solver, concentration, [](auto const& x) { return 0.5 + 0.4 * std::sin(6 * x[0] + 5 * x[1]); });
    return rates_of(solver);
  };
  auto const level = rates_with(segregation);
  CHECK(rates_with(Under{segregation}) == level);
  CHECK(rates_with(Under{segregation, {1.62, 0}}) == level);
  auto const along_x = rates_with(Under{segregation, {9.81, std::numbers::pi / 2}});
  // Rotated by a right angle: the gain of the block at the end that gravity points to.
  auto const x = fill_lattice(Box<2>{{0, 0}, {1, 0.6}}, 0.1);
  double drift_x = 0, drift_y = 0;
  for (std::size_t i = 0; i < x.size(); ++i) drift_x += along_x[i] * x[i][0], drift_y += level[i] * x[i][1];
  CHECK(drift_x > 0);
  CHECK(drift_y < 0);
  CHECK_THROWS_AS((Under{{{.velocity = -1}}, {}}.limits({})), std::invalid_argument);
}

TEST_CASE("a concentration outside of its range is refused, whatever surrounds the segregation") {
  using Alone = ConservativeSegregation<ConstantClosure>;
  auto const expect_refused = [](auto const& physics) {
    using Model = std::remove_cvref_t<decltype(physics)>;
    auto solver = solver_of<Formulated<OnHost, Model>>(layer({1, 0.6}, 0.1), 0.1, physics);
    set_field(solver, concentration, [](auto const& x) { return x[0] > 0.9 ? 1.01 : 0.5; });
    CHECK_THROWS_AS(solver.step(1), OutsideValidity);
  };
  expect_refused(Alone{});
  expect_refused(UnderGravity<Alone>{});
  expect_refused(HybridSegregation<ConstantClosure>{});
  expect_refused(UnderGravity<HybridSegregation<ConstantClosure>>{});
  SegregatingGranular<Granular<>, Alone> flowing;
  flowing.mechanics.law = {.elastic = {1e5, 0.3, 1500}, .grains = {0.01}};
  expect_refused(flowing);
}

TEST_CASE("the concentration changes the strength of the flowing material") {
  // Small grains have a lower inertial number, and so less friction.
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
  // The rate at the middle of one step is used for n steps: the error is (n - 1) dt/2 times its change. Without
  // feedback the motion is the same in all runs. 180 steps are whole intervals of 5 and of 9.
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
  // Steps are adjusted evenly over 1000 s: a change of 1e-3 of a step at most.
  double const short_step = at_seventh.step(1000), long_step = at_every.step(1000);
  CHECK(at_seventh.limits() == std::map<std::string, long>{{"segregation", 1}});
  CHECK(at_every.limits() == std::map<std::string, long>{{"segregation", 1}});
  CHECK(std::abs(long_step / short_step - 7) < 1e-3);
  CHECK(flowing(7, true).step(1000) == flowing(1, true).step(1000));  // that of the mechanics
}

}  // namespace scree::test::segregating_tests
