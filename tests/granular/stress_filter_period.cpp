// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/stress_filter.hpp>

#include <support/formulations.hpp>
#include <support/set_to.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

// The steps at which filters run.
namespace scree::test::stress_filter_period_tests {
using namespace fields;

namespace {

using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
double const dr = 0.125;

Vec<4, double> uneven(Vec<2, double> const& x) { return std::sin(40 * x[0]) * Vec<4, double>::Ones(); }

template <class Filter>
struct OnlyFilters {
  Filter filter;
  using evolves = Fields<Stress, Yielding>;
  auto passes(Resolution const&) const { return std::tuple(point_pass<Material>("stays", SetTo<StressRate>{0})); }
  auto projections(Resolution const&) const { return std::tuple(point_pass<Material>("yield", SetTo<Yielding>{1})); }
  auto filters(Resolution const&) const { return filter.passes(); }
  int filter_period() const { return filter.period; }
  auto limits(Resolution const&) const { return std::tuple(limit("step", 0.1)); }
};
using Filtering = Formulated<OnHost, OnlyFilters<LinearFilter>>;
auto filtering(int period) {
  auto solver = solver_of<Filtering>({lattice<2>(dr), {}}, dr, {{.period = period}});
  solver.set(stress, uneven);
  return solver;
}
/// The steps after which the stress has changed.
std::vector<long> changes(Solver<Filtering>& solver, long until) {
  std::vector<long> found;
  while (solver.steps() < until) {
    auto const before = solver.material().to_host(stress);
    solver.step(1);
    if (solver.material().to_host(stress) != before) found.push_back(solver.steps());
  }
  return found;
}

}  // namespace

TEST_CASE("a filter is run at the end of every period-th step") {
  auto every_third = filtering(3), every_step = filtering(1);
  CHECK(changes(every_third, 8) == std::vector<long>{3, 6});
  CHECK(changes(every_step, 3) == std::vector<long>{1, 2, 3});
  CHECK(std::tuple_size_v<decltype(NoFilter{}.passes())> == 0);
  CHECK_THROWS_WITH(filtering(0).step(1), Catch::Matchers::ContainsSubstring("must be 1 or more, not 0"));
}

TEST_CASE("yielding is counted anew after the filter") {
  auto solver = filtering(3);
  changes(solver, 2);
  CHECK(solver.material().to_host(yielding)[0] == 1);
  changes(solver, 3);
  CHECK(solver.material().to_host(yielding)[0] == 0);
}

TEST_CASE("the phase of a filter survives a snapshot") {
  auto whole = filtering(3), first = filtering(3), second = filtering(3);
  changes(whole, 8);
  changes(first, 4);
  second.restore(first.snapshot());
  CHECK(changes(second, 8) == std::vector<long>{6});
  CHECK(second.snapshot() == whole.snapshot());
}

}  // namespace scree::test::stress_filter_period_tests
