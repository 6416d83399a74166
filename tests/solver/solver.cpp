// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/neighbours/brute_force.hpp>
#include <scree/neighbours/verlet_list.hpp>
#include <scree/segregation/conservative.hpp>
#include <scree/segregation/hybrid.hpp>
#include <scree/solver/solver.hpp>

#include <support/set_to.hpp>
#include <support/shear_box.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace scree::test::solver_tests {
using namespace fields;

namespace {

using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;

struct Growth {
  double longest = 0.3;
  using evolves = Fields<Concentration>;
  auto passes(Resolution const&) const {
    return std::tuple(point_pass<Material>("growth", SetTo<ConcentrationRate>{1}));
  }
  auto limits(Resolution const&) const { return std::tuple(limit("growth", longest)); }
};
using Growing = Formulated<OnHost, Growth>;

auto growing(double longest = 0.3) { return solver_of<Growing>({lattice<2>(0.25), {}}, 0.25, {longest}); }

using Conservative = ConservativeSegregation<ConstantClosure>;
using Hybrid = HybridSegregation<ConstantClosure>;

template <class Space, class Physics>
using OnSpaceBox = Formulated<Policy<2, double, Space>, Physics, OscillatingShear>;

/// Concentrations of the shear box after two periods.
template <class P>
std::vector<double> after_two_periods() {
  auto solver = shear_box::at_rest<P>(0.04, {shear_box::closure(), SegregationFlux::asymmetric()});
  solver.run(2);
  return concentrations_of(solver);
}
double largest_difference(std::vector<double> const& a, std::vector<double> const& b) {
  double largest = a.size() == b.size() ? 0 : 1;
  for (std::size_t k = 0; k < a.size() && k < b.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

template <class P, template <class...> class Search>
struct Searching : P {
  template <class Q>
  using search = Search<Q>;
};

}  // namespace

TEST_CASE("a solver takes points, groups, braces and what converts to points, in any combination") {
  struct Own : std::vector<Vec<2, double>> {};
  Own own;
  own.push_back({0.5, 0.5});
  std::vector<Vec<2, double>> const points{{0, 0}, {0.25, 0}};
  auto const list = {Vec<2, double>(1, 1), Vec<2, double>(2, 1), Vec<2, double>(3, 1)};
  Groups<2> groups;
  groups.add("first", points);
  SolverSettings<Growing> const settings{.spacing = 0.25};
  auto const number = [](Solver<Growing> const& solver) {
    return std::pair(solver.material().size(), solver.wall().size());
  };
  CHECK(number(Solver<Growing>({.spacing = 0.25}, {{0, 0}, {0.25, 0}}, {})) == std::pair(2, 0));
  CHECK(number(Solver<Growing>(settings, points, groups)) == std::pair(2, 2));
  CHECK(number(Solver<Growing>(settings, own, groups)) == std::pair(1, 2));
  CHECK(number(Solver<Growing>(settings, groups, own)) == std::pair(2, 1));
  CHECK(number(Solver<Growing>(settings, list)) == std::pair(3, 0));
  CHECK(number(Solver<Growing>(settings, particles_of<Wall>(points), particles_of<Material>(own))) == std::pair(1, 2));
}
TEST_CASE("observers are called at their times, which are met exactly") {
  using S = Solver<Growing>;
  auto solver = growing();
  std::vector<double> regular, chosen;
  double grown = 0;
  S::Observers const observers{every<S>(0.25, [&](S& s) { regular.push_back(s.time()); }),
                               at<S>({1.4, 0.1, 0.7}, [&](S& s) {
                                 chosen.push_back(s.time());
                                 grown = std::max(grown, std::abs(concentrations_of(s)[3] - s.time()));
                               })};
  solver.run(1.5, observers);
  CHECK(regular == std::vector<double>{0, 0.25, 0.5, 0.75, 1, 1.25, 1.5});
  CHECK(chosen == std::vector<double>{0, 0.1, 0.7, 1.4});  // every observer sees the start
  CHECK(grown < 1e-14);
  CHECK(solver.time() == 1.5);
  // No step is longer than 0.3: the gaps between 0, .1, .25, .5, .7, .75, 1, 1.25, 1.4, 1.5 take one step each.
  CHECK(solver.steps() == 9);
  CHECK(solver.limits() == std::map<std::string, long>{{"output", 9}});
}

TEST_CASE("a run goes on where the last one ended") {
  using S = Solver<Growing>;
  auto solver = growing();
  std::vector<double> times;
  S::Observers const observers{every<S>(0.4, [&](S& s) { times.push_back(s.time()); })};
  solver.run(0.5, observers);
  solver.run(1, observers);
  CHECK(times.size() == 3);  // the start is seen once
  CHECK(solver.time() == 1);
}

TEST_CASE("the limits of the steps are named and counted") {
  auto solver = growing(0.1);
  solver.run(1);
  CHECK(solver.steps() == 10);
  long counted = 0;
  for (auto const& [name, count] : solver.limits()) {
    counted += count;
    CHECK((name == "growth" || name == "output"));  // the last step may be decided by either
  }
  CHECK(counted == 10);
  CHECK(solver.limits().at("growth") >= 9);

  // The remaining time decides the last step. In the shear box the motion decides all others: 0.05/(gamma0 2 pi) =
  // 0.0138 T against 0.1 h/V = 0.35 T and 0.1 h^2/D = 1.07 T.
  using Box = OnSpaceBox<Kokkos::DefaultHostExecutionSpace, Conservative>;
  auto box = shear_box::at_rest<Box>(0.04, {shear_box::closure(), {}});
  box.run(0.5);
  CHECK(box.limits().at("motion") == box.steps() - 1);
  auto slow = shear_box::closure();
  slow.diffusivity *= 1000;
  auto diffusive = shear_box::at_rest<Box>(0.04, {slow, {}});
  diffusive.run(0.1);
  CHECK(diffusive.limits().at("diffusion") == diffusive.steps() - 1);
  auto fast = shear_box::closure();
  fast.velocity *= 1000;
  auto segregating = shear_box::at_rest<Box>(0.04, {fast, {}});
  segregating.run(0.1);
  CHECK(segregating.limits().at("segregation") == segregating.steps() - 1);
}

TEST_CASE("a run of no length takes no step") {
  using S = Solver<Growing>;
  auto solver = growing();
  int calls = 0;
  solver.run(0, {every<S>(1, [&](S&) { ++calls; })});
  CHECK(solver.steps() == 0);
  CHECK(solver.time() == 0);
  CHECK(calls == 1);
  CHECK(concentrations_of(solver)[0] == 0);
}

TEST_CASE("a solver starts with what it is given") {
  auto const solver = growing();
  CHECK(solver.material().size() == 16);
  CHECK(solver.wall().size() == 0);
  for (double const one : solver.material().to_host(volume)) CHECK(one == 0.0625);
  auto const names = solver.material().to_host(identity);
  for (int k = 0; k < 16; ++k) CHECK(names[std::size_t(k)] == k);
  auto const resolution = solver.resolution();
  CHECK(resolution.smoothing_length == 1.5 * 0.25);
  CHECK(resolution.support == 3 * 0.25);
}

TEST_CASE("bad settings stop with a message in words") {
  using Catch::Matchers::StartsWith;
  auto const with = [](double spacing, double smoothing, std::vector<Period> periods = {}) {
    SolverSettings<Growing> settings;
    settings.spacing = spacing;
    settings.smoothing = smoothing;
    settings.periods = std::move(periods);
    Solver<Growing>(settings, lattice<2>(0.25));
  };
  double const nan = std::numeric_limits<double>::quiet_NaN();
  for (double const bad : {0.0, -0.1, nan})
    CHECK_THROWS_WITH(with(bad, 1.5), StartsWith("scree: spacing (m) must be above 0, not "));
  for (double const bad : {1.0, 3.5, nan})
    CHECK_THROWS_WITH(with(0.1, bad), StartsWith("scree: smoothing (h/spacing) must be from 1.1 to 3"));
  CHECK_THROWS_WITH(with(0.1, 1.5, {{.axis = 2, .low = 0, .high = 10}}),
                    StartsWith("scree: the axis of a period must be an axis of the space, not 2"));
  CHECK_THROWS_WITH(with(0.1, 1.5, {{.axis = 0, .low = 0, .high = 0.5}}),
                    StartsWith("scree: the length (m) of a period, high - low, must be two supports or more, not 0.5"));
  auto solver = growing(-1);
  CHECK_THROWS_WITH(solver.run(1), StartsWith("scree: the growth limit of the time step is "));
  auto short_of_values = growing();
  CHECK_THROWS_WITH(short_of_values.set(concentration, std::vector<int>{1, 2}, [](int) { return 0.5; }),
                    StartsWith("scree: concentration needs one value for each owned particle"));
}

TEMPLATE_LIST_TEST_CASE("a run repeated gives the same bits", "", Backends) {
  CHECK(largest_difference(after_two_periods<OnSpaceBox<TestType, Conservative>>(),
                           after_two_periods<OnSpaceBox<TestType, Conservative>>()) == 0);
  CHECK(largest_difference(after_two_periods<OnSpaceBox<TestType, Hybrid>>(),
                           after_two_periods<OnSpaceBox<TestType, Hybrid>>()) == 0);
}

#ifdef KOKKOS_ENABLE_SERIAL
TEST_CASE("one thread or many give the same bits") {
  // ctest runs this program with two threads.
  CHECK(largest_difference(after_two_periods<OnSpaceBox<Kokkos::Serial, Conservative>>(),
                           after_two_periods<OnSpaceBox<Kokkos::DefaultHostExecutionSpace, Conservative>>()) == 0);
  CHECK(largest_difference(after_two_periods<OnSpaceBox<Kokkos::Serial, Hybrid>>(),
                           after_two_periods<OnSpaceBox<Kokkos::DefaultHostExecutionSpace, Hybrid>>()) == 0);
}
#endif

TEMPLATE_LIST_TEST_CASE("a run does not depend on the neighbour search but for rounding", "", Backends) {
  // Searches offer neighbours in different orders; sums differ in the last digits, which diffusion damps.
  using P = OnSpaceBox<TestType, Conservative>;
  auto const by_cells = after_two_periods<P>();
  CHECK(largest_difference(by_cells, after_two_periods<Searching<P, VerletList>>()) < 1e-12);
  CHECK(largest_difference(by_cells, after_two_periods<Searching<P, BruteForce>>()) < 1e-12);
}

TEST_CASE("walls follow the motion of the material") {
  using Box = OnSpaceBox<Kokkos::DefaultHostExecutionSpace, Conservative>;
  auto const bed = open_bed<2>({shear_box::width, 1}, 0.04);
  auto solver = shear_box::at_rest<Box>(0.04, {shear_box::closure(), {}});
  solver.run(0.25);
  auto const material = solver.material().to_host(position), wall = solver.wall().to_host(position);
  double error = 0;
  for (std::size_t i = 0; i < material.size(); ++i)
    error = std::max(error, std::abs(material[i][0] - bed.material[i][0] - shear_box::gamma0 * bed.material[i][1]));
  for (std::size_t i = 0; i < wall.size(); ++i)
    error = std::max(error, std::abs(wall[i][0] - bed.wall[i][0] - shear_box::gamma0 * bed.wall[i][1]));
  CHECK(error < 1e-13);  // displacements of some 40 half steps add up
}

}  // namespace scree::test::solver_tests
