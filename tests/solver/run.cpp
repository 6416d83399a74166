// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/solver/solver.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

namespace scree::test::run_tests {
using namespace fields;

/// Number of runs of a pass.
struct Runs : Scalar<"runs", "1"> {};
inline constexpr Runs runs{};
struct CountRuns {
  using reads = Fields<Runs>;
  using writes = Fields<Runs>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[runs] = i[runs] + 1;
  }
};
/// C' = C.
struct GrowsByItself {
  using reads = Fields<Concentration>;
  using writes = Fields<ConcentrationRate>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[concentration_rate] = i[concentration];
  }
};

namespace {

using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;

auto counting() { return std::tuple(point_pass<Material>("count", CountRuns{}), point_pass<Wall>("", CountRuns{})); }

/// Counts at every third step.
struct Growth {
  using evolves = Fields<Concentration>;
  auto passes(Resolution const& resolution) const {
    return std::tuple_cat(std::tuple(point_pass<Material>("growth", GrowsByItself{})),
                          only_if(resolution.steps % 3 == 0, counting()));
  }
  auto limits(Resolution const&) const { return std::tuple(limit("growth", 0.125)); }
};
using Growing = Formulated<OnHost, Growth>;
using S = Solver<Growing>;

S growing(double spacing = 0.25) {
  auto solver = solver_of<Growing>({lattice<2>(spacing), {{5, 5}}}, spacing);
  solver.set(concentration, [](auto const& x) { return x[0]; });
  return solver;
}
template <class B>
concept TargetOfPasses = requires {
  point_pass<B>("", CountRuns{});
};

}  // namespace

TEST_CASE("bodies of passes are material and walls, and nothing else") {
  STATIC_CHECK(TargetOfPasses<Material>);
  STATIC_CHECK(TargetOfPasses<Wall>);
  STATIC_CHECK_FALSE(TargetOfPasses<Concentration>);
  STATIC_CHECK_FALSE(TargetOfPasses<int>);
  STATIC_CHECK_FALSE(TargetOfPasses<Material&>);
}

TEST_CASE("passes with a condition are run where it holds, and bring their fields anyway") {
  using Passes = decltype(only_if(false, counting()));
  STATIC_CHECK(std::is_same_v<fields_of_passes<Material, Passes>, Fields<Runs>>);
  STATIC_CHECK(std::is_same_v<fields_of_passes<Wall, Passes>, Fields<Runs>>);
  auto solver = growing();
  std::vector<double> found;
  for (int step = 0; step < 7; ++step) {
    solver.step(1);
    found.push_back(solver.material().to_host(runs)[5]);
  }
  // Steps 0, 3 and 6, twice each: the midpoint scheme evaluates all passes twice, with one number of steps.
  CHECK(found == std::vector<double>{2, 2, 2, 4, 4, 4, 6});
  CHECK(solver.wall().to_host(runs)[0] == 6);
}

TEST_CASE("a run can be stopped after each step, and goes on") {
  auto solver = growing();
  long asked = 0;
  std::vector<double> seen;
  S::Observers const observers{every<S>(0.25, [&](S& s) { seen.push_back(s.time()); })};
  solver.run(2, observers, [&](S const& s) {
    ++asked;
    CHECK(s.steps() == asked);
    return asked == 4;
  });
  CHECK(asked == 4);
  CHECK(solver.steps() == 4);
  CHECK(solver.time() == 0.5);
  CHECK(seen == std::vector<double>{0, 0.25, 0.5});  // what is due at the last step is done
  solver.run(1, observers, [](S const&) { return false; });
  CHECK(solver.time() == 1);
  CHECK(seen == std::vector<double>{0, 0.25, 0.5, 0.75, 1});
  solver.run(1, {}, [&](S const&) { return ++asked > 0; });
  CHECK(asked == 4);  // `stop` is not called without a step
}

TEST_CASE("an observer at the start sees the rates of the initial state") {
  auto solver = growing();
  double rate = 0;
  solver.run(0, {every<S>(1, [&](S& now) { rate = now.material().to_host(concentration_rate)[0]; })});
  CHECK(rate == solver.material().to_host(concentration)[0]);
  CHECK(rate > 0);
}

TEST_CASE("times that make no sense are refused") {
  using Catch::Matchers::StartsWith;
  double const infinite = std::numeric_limits<double>::infinity(), nan = std::nan("");
  auto solver = growing();
  for (double const bad : {0.0, -1e-4, -infinite, nan})
    CHECK_THROWS_WITH(solver.step(bad), StartsWith("scree: the length of a step (s) must be above 0, not "));
  for (double const bad : {-1.0, nan, infinite})
    CHECK_THROWS_WITH(solver.run(bad), StartsWith("scree: the end of a run (s) must be 0 or more, and finite "));
  for (double const bad : {-1.0, nan})
    CHECK_THROWS_AS(solver.run(bad, {}, [](S const&) { return true; }), std::invalid_argument);
  for (double const bad : {0.0, -1.0, -1e-19, nan})
    CHECK_THROWS_WITH(every<S>(bad, [](S&) {}), StartsWith("scree: the interval of every() (s) must be above 0"));
  CHECK(solver.steps() == 0);
  CHECK(solver.step(infinite) == 0.125);  // the limit
  solver.run(infinite, {}, [](S const& s) { return s.steps() == 5; });
  CHECK(solver.time() == 0.625);
}

TEST_CASE("a run whose steps are too short to end stops with a message") {
  for (double const interval : {1e-19, 1e-300}) {
    auto solver = growing();
    CHECK_THROWS_WITH(solver.run(1, {every<S>(interval, [](S&) {})}),
                      Catch::Matchers::ContainsSubstring("the last by the output limit, took ") &&
                          Catch::Matchers::EndsWith("which would not end"));
    CHECK(solver.steps() < 2000);
  }
  auto solver = growing();
  CHECK_THROWS_AS(solver.run(std::numeric_limits<double>::max()), std::invalid_argument);
}

TEST_CASE("a solver goes on from a snapshot bit by bit") {
  auto whole = growing(), first = growing(), second = growing();
  whole.run(2);
  first.run(2, {}, [](S const& s) { return s.steps() == 7; });
  auto const snapshot = first.snapshot();
  CHECK(snapshot.time == 7 * 0.125);
  CHECK(snapshot.steps == 7);
  CHECK(counters_of(snapshot, "step limits") == first.limits());
  second.run(0.4);  // must be overwritten
  second.restore(snapshot);
  CHECK(second.snapshot() == snapshot);
  CHECK(second.time() == first.time());
  CHECK(second.limits() == first.limits());
  second.run(2);
  CHECK(second.steps() == 16);
  CHECK(second.snapshot() == whole.snapshot());
  CHECK(second.material().to_host(runs)[0] == 12);  // steps 0, 3, ... 15
}

TEST_CASE("a solver refuses the snapshot of another number of particles, and stays as it is") {
  auto solver = growing(), finer = growing(0.125);
  solver.run(0.5);
  finer.run(1);
  auto const before = solver.snapshot();
  CHECK_THROWS_WITH(solver.restore(finer.snapshot()), Catch::Matchers::StartsWith("scree: the snapshot: "));
  CHECK(solver.snapshot() == before);
}

}  // namespace scree::test::run_tests
