// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Steps that run before it is known that neighbour lists are valid, as on a GPU, here also on the host.
#define SCREE_TRIALS_ON_HOST
#include <openings/support.hpp>
#include <support/policies.hpp>
#include <support/sudden.hpp>

#include <catch2/catch_template_test_macros.hpp>

namespace scree::test::trials_tests {
using namespace fields;
namespace {

template <class Space>
using Starting = WithLists<Policy<2, double, Space>, SuddenStart, SymplecticEuler>;

template <class P>
Solver<P> starting() {
  return sudden::at_rest<P>({0.05, 4});
}
/// The state at the end, and the steps at which lists were built.
template <class P>
bool same(Solver<P> const& a, Solver<P> const& b) {
  return a.steps() == b.steps() && a.time() == b.time() && a.neighbour_builds() == b.neighbour_builds() &&
         a.limits() == b.limits() && a.material().to_host(position) == b.material().to_host(position) &&
         a.material().to_host(velocity) == b.material().to_host(velocity);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("steps taken with lists that no longer served are repeated", "", Backends) {
  using Q = Policy<2, double, TestType>;
  sudden::for_each_case([](char const* name, auto const& motion, auto const& act) {
    INFO(name);
    auto const euler = sudden::compare<Q, SymplecticEuler>(name, motion, act);
    CHECK(euler.failed_trials() < euler.neighbour_builds());
    sudden::compare<Q, Midpoint>(name, motion, act);
  });
}

TEMPLATE_LIST_TEST_CASE("results do not depend on when displacements were looked at", "", Backends) {
  using P = Starting<TestType>;
  using S = Solver<P>;
  auto by_run = starting<P>(), by_step = starting<P>(), observed = starting<P>(), asked = starting<P>();
  by_run.run(sudden::end);
  REQUIRE(by_run.failed_trials() > 0);

  // step() has no trials.
  while (by_step.time() < sudden::end) by_step.step(sudden::end - by_step.time());
  CHECK(by_step.failed_trials() == 0);
  CHECK(same(by_run, by_step));

  // No observer sees a state that is taken back.
  double last = 0;
  bool forwards = true;
  observed.run(sudden::end, {}, [&](S const& s) {
    forwards = forwards && s.time() > last;
    last = s.time();
    return false;
  });
  CHECK(forwards);
  CHECK(same(by_run, observed));

  int calls = 0;
  asked.run(
      sudden::end, {}, [&](S const&) { return ++calls == 7; }, [&] { return calls < 6 || asked.time() > 0.08; });
  CHECK(calls == 7);
  CHECK(asked.time() > 0.08);
  asked.run(sudden::end);
  CHECK(same(by_run, asked));
}

TEMPLATE_LIST_TEST_CASE("a run that goes on from any step repeats what the whole run repeated", "", Backends) {
  using P = Starting<TestType>;
  using S = Solver<P>;
  auto whole = starting<P>();
  whole.run(sudden::end);
  for (long const step : {1, 30, 499, 500, 501, 502, 505, 520, 700}) {
    auto first = starting<P>(), second = starting<P>();
    first.run(sudden::end, {}, [&](S const& s) { return s.steps() >= step; });
    REQUIRE(first.steps() == step);
    second.restore(first.snapshot());
    second.run(sudden::end);
    INFO("from step " << step);
    CHECK(same(whole, second));
  }
}

TEMPLATE_LIST_TEST_CASE("an error that follows from lists that no longer served is not reported", "", Backends) {
  using P = Starting<TestType>;
  auto solver = starting<P>();
  int calls = 0;
  // asks() sees the step that a trial took; an error of the caller is passed on, and the state is correct then.
  CHECK_THROWS_AS(solver.run(
                      sudden::end, {}, [](auto const&) { return true; },
                      [&]() -> bool {
                        if (++calls == 510) throw std::invalid_argument("the caller's own");
                        return false;
                      }),
                  std::invalid_argument);
  solver.run(sudden::end);
  auto whole = starting<P>();
  whole.run(sudden::end);
  CHECK(same(whole, solver));
}

TEMPLATE_LIST_TEST_CASE("particles come and go between trials as between single steps", "", Backends) {
  using P = FedSand<Policy<2, double, TestType>, SymplecticEuler>;
  auto by_run = fed<P>(), by_step = fed<P>();
  double const end = 1.03;
  by_run.run(end);
  while (by_step.time() < end) by_step.step(end - by_step.time());
  REQUIRE(by_run.left()[0].particles > 0);
  CHECK(same(by_run, by_step));
  CHECK(by_run.material().to_host(identity) == by_step.material().to_host(identity));
  CHECK(by_run.left()[0].particles == by_step.left()[0].particles);
  check_ledger(by_run);

  // From the middle of a trial.
  auto first = fed<P>(), second = fed<P>();
  first.run(end, {}, [](auto const& now) { return now.steps() >= 57; });
  second.restore(first.snapshot());
  second.run(end);
  CHECK(same(by_run, second));
}

}  // namespace scree::test::trials_tests
