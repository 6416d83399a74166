// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Steps that are repeated on several ranks, which find together that lists no longer served.
#define SCREE_TRIALS_ON_HOST
#include <distributed/on_ranks.hpp>
#include <openings/support.hpp>
#include <support/sudden.hpp>

#include <stdexcept>

namespace scree::test::ranks_tests {
namespace {

using Host = Kokkos::DefaultHostExecutionSpace;
using TeamOfHost = Team<Host>;

/// A block at rest, and a plate that starts suddenly.
struct Sudden {
  using S = Solver<OnRanks<WithLists<Policy<2, double, Host>, SuddenStart, SymplecticEuler>>>;
  static constexpr double end = sudden::end;
  static S make(TeamOfHost const& team, Host const& space) {
    auto const bed = sudden::block_and_plate();
    return S(space, {.spacing = sudden::spacing, .motion = {0.05, 4}, .lost_share = 1, .ranks = {.team = team}},
             bed.material, bed.wall);
  }
};
/// A block that is fed at one end and drained at the other.
struct Fed {
  using S = Solver<OnRanks<FedSand<Policy<2, double, Host>, SymplecticEuler>>>;
  static constexpr double end = 1.03;
  static S make(TeamOfHost const& team, Host const& space) {
    S solver(space, {.spacing = dr, .physics = weightless(), .ranks = {.team = team}}, slab<2>(0, 0.8, 4));
    solver.set(fields::velocity, [](auto const&) { return Vec<2, double>(speed, 0); });
    solver.feed(pushing<2>(4));
    solver.drain({}, beyond<2>(1));
    return solver;
  }
};

struct End {
  std::uint64_t hash = 0;
  long steps = 0, builds = 0, most_failures = 0, least_failures = 0, removed = 0;
  std::int64_t migrated = 0;
};
/// advance(solver) takes the solver to the end.
template <class Case, class Advance>
End end_on(int ranks, Advance const& advance) {
  End end;
  run_on_threads<Host>(ranks, [&](TeamOfHost const& team, Host const& space) {
    auto solver = Case::make(team, space);
    advance(solver);
    auto const hash = state_hash(solver);
    End const found{hash,
                    solver.steps(),
                    solver.neighbour_builds(),
                    team.largest(solver.failed_trials()),
                    team.smallest(solver.failed_trials()),
                    solver.turnover().removed,
                    team.sum(solver.ranks().counts().migrated)};
    if (team.rank() == 0) end = found;
  });
  return end;
}
template <class Case>
End check_ranks() {
  // step() has no trials.
  auto const by_step = end_on<Case>(1, [](auto& solver) {
    while (solver.time() < Case::end) solver.step(Case::end - solver.time());
  });
  CHECK(by_step.most_failures == 0);
  for (int const ranks : {1, 2, 3}) {
    INFO(ranks << " ranks");
    auto const by_run = end_on<Case>(ranks, [](auto& solver) { solver.run(Case::end); });
    CHECK(by_run.least_failures == by_run.most_failures);
    CHECK(by_run.hash == by_step.hash);
    CHECK(by_run.steps == by_step.steps);
    CHECK(by_run.builds == by_step.builds);
    CHECK((by_run.migrated > 0) == (ranks > 1));
    if (ranks == 3) return by_run;
  }
  return {};
}

}  // namespace

TEST_CASE("ranks repeat steps together", "[ranks]") { CHECK(check_ranks<Sudden>().most_failures > 0); }

TEST_CASE("particles come and go between trials of several ranks", "[ranks]") { CHECK(check_ranks<Fed>().removed > 0); }

TEST_CASE("an error of one rank among steps that may be repeated ends all ranks", "[ranks]") {
  CHECK_THROWS_AS(end_on<Sudden>(3,
                                 [](auto& solver) {
                                   bool const fails = solver.ranks().team().rank() == 1;
                                   int calls = 0;
                                   solver.run(
                                       Sudden::end, {}, [](auto const&) { return false; },
                                       [&]() -> bool {
                                         if (fails && ++calls == 510) throw std::invalid_argument("of one rank");
                                         return false;
                                       });
                                 }),
                  std::invalid_argument);
}

}  // namespace scree::test::ranks_tests
