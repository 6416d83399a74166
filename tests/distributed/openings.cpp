// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "on_ranks.hpp"

#include <support/weightless_sand.hpp>

#include <scree/granular/granular.hpp>
#include <scree/openings/ledger.hpp>
#include <scree/openings/regions.hpp>
#include <scree/setup/setup.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cstring>

// Particles that come to a case on ranks and leave it.
namespace scree::test::openings_tests {
using namespace fields;
namespace {

using Catch::Matchers::ContainsSubstring;
using V = Vec<2, double>;
double const dr = 0.1;  // m

struct Sand : Formulation<2> {
  using space = Space;
  using physics = Granular<>;
  using carries = Fields<Held>;
};
/// Particles that left through the drain of a chute: times, identities and velocities, one behind the other.
using Gone = std::vector<double>;

/// A bed between walls that slides towards a drain, with a column that is pushed behind it and a shower above.
template <class F>
Solver<F> chute(Space const& space, SolverSettings<F> settings, std::shared_ptr<Gone> const& gone) {
  settings.spacing = dr;
  settings.lost_share = 1;
  settings.physics = weightless();
  settings.physics.gravity = {1};
  Solver<F> solver(space, settings, fill_lattice(Box<2>{{0, 0}, {1.6, 0.8}}, dr),
                   fill_lattice(Box<2>{{-1, -0.4}, {2, 0}}, dr));
  solver.set(velocity, [](auto const& x) { return V(1, -0.1 * x[1]); });
  solver.feed({.name = "column", .layer = fill_lattice(Box<2>{{-dr, 0}, {0, 0.8}}, dr), .velocity = {1, 0}});
  solver.feed({.name = "shower",
               .layer = fill_lattice(Box<2>{{0.2, 1.5}, {1.2, 1.6}}, dr),
               .velocity = {0, -1},
               .pushes = false,
               .rate = 0.5});
  solver.drain({.name = "out"}, Beyond<2>{{1.7, 0}, {1, 0}}, Fields<Velocity>{}, [gone](double time, auto const& all) {
    for (auto const& each : all)
      for (double const number : {time, double(each[identity]), each[velocity][0]}) gone->push_back(number);
  });
  return solver;
}
/// Sand under pressure between periodic ends that moves from an inlet to an open end.
template <class F>
Solver<F> column(Space const& space, SolverSettings<F> settings) {
  settings.spacing = dr;
  settings.physics = weightless();
  settings.periods = {{1, 0, 8 * dr}};
  Solver<F> solver(space, settings, fill_lattice(Box<2>{{0, 0}, {2, 8 * dr}}, dr));
  Vec<4, double> const under(-1000, -1000, -1000, 0);
  solver.set(stress, [=](auto const&) { return under; });
  solver.set(velocity, [](auto const& x) { return V(1, 0.2 * x[0]); });
  solver.feed({.layer = fill_lattice(Box<2>{{-dr, 0}, {0, 8 * dr}}, dr), .velocity = {1, 0}}, given(stress, under));
  solver.open_end({.point = {1.3, 0}, .normal = {1, 0}}, given(stress, under));
  return solver;
}

/// A block that slides over a wall.
template <class F>
Solver<F> block(Space const& space, SolverSettings<F> settings) {
  settings.spacing = dr;
  settings.lost_share = 1;
  settings.physics = weightless();
  Solver<F> solver(space, settings, fill_lattice(Box<2>{{0, 0}, {1.6, 0.8}}, dr),
                   fill_lattice(Box<2>{{-1, -0.4}, {3, 0}}, dr));
  solver.set(velocity, [](auto const& x) { return V(1, -0.1 * x[1]); });
  return solver;
}

struct End {
  std::uint64_t hash = 0;
  Ledger all = {};
  Gone gone = {};
  Snapshot middle = {};
  bool operator==(End const& other) const {
    auto const numbers = [](Ledger const& l) {
      std::vector<double> list = {double(l.at_start), double(l.entered), double(l.left),
                                  double(l.added),    double(l.removed), double(l.present)};
      for (auto const& passed : {l.inlets, l.drains})
        for (auto const& each : passed) list.push_back(double(each.particles)), list.push_back(each.volume);
      return list;
    };
    return hash == other.hash && gone == other.gone && numbers(all) == numbers(other.all);
  }
};
template <class S>
End end_of(S& solver, double middle, double until, std::shared_ptr<Gone> const& gone) {
  End end;
  if (solver.time() < middle) solver.run(middle), end.middle = solver.snapshot();
  solver.run(until);
  check_ledger(solver);
  return {state_hash(solver), ledger(solver), *gone, end.middle};
}
/// Runs on ranks from the beginning or from a snapshot.
template <class Make>
End end_on(int ranks, Make const& make, Snapshot const* from = nullptr) {
  End end;
  run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) {
    SolverSettings<OnRanks<Sand>> settings;
    settings.ranks.team = team;
    auto const gone = std::make_shared<Gone>();
    auto solver = make(space, settings, gone);
    if (from != nullptr) solver.restore(*from);
    auto const found = end_of(solver, 0.4, 0.9, gone);
    if (team.rank() == 0) end = found;
  });
  return end;
}
template <class Make>
void check_same(Make const& make) {
  auto const gone = std::make_shared<Gone>();
  auto whole = make(Space(), SolverSettings<Whole<Sand>>{}, gone);
  auto const end = end_of(whole, 0.4, 0.9, gone);
  CHECK(end.all.entered > 20);
  CHECK(end.all.left > 20);
  auto const one = end_on(1, make);
  CHECK(one == end);
  for (int ranks : {2, 3, 4}) {
    INFO(ranks << " ranks");
    auto const several = end_on(ranks, make);
    CHECK(several == end);
    CHECK(several.middle == one.middle);
    CHECK(end_on(ranks, make, &one.middle).hash == end.hash);
    CHECK(end_on(1, make, &several.middle).hash == end.hash);
  }
}

}  // namespace

TEST_CASE("a chute with two inlets and a drain has the same bits and the same ledger on any number of ranks") {
  check_same([](Space const& space, auto const& settings, auto const& gone) { return chute(space, settings, gone); });
}

TEST_CASE("a periodic column with an inlet and an open end has the same bits on any number of ranks") {
  check_same([](Space const& space, auto const& settings, auto const&) { return column(space, settings); });
}

TEST_CASE("particles are added and removed on all ranks, at the start and later") {
  auto const run = [](auto& solver) {
    std::vector<double> log;
    auto const change = [&] {
      double const top = solver.time() > 0 ? 2 : 1.2;
      solver.add(fill_lattice(Box<2>{{0.3, top}, {0.9, top + 0.2}}, dr), given(velocity, V(0.3, 0)));
      auto const removed =
          solver.remove(Within<2>{{0.2, 0.1}, {0.5 + solver.time(), 0.4}}, Fields<Identity, Velocity, Position>{});
      for (auto const& each : removed)
        for (double const number : {double(each[identity]), each[velocity][0], each[position][1]})
          log.push_back(number);
    };
    change();
    for (int k = 0; k < 3; ++k) {
      for (int step = 0; step < 20; ++step) solver.step(1);
      if (k < 2) change();
    }
    check_ledger(solver);
    log.push_back(double(solver.turnover().added)), log.push_back(double(solver.turnover().removed));
    return log;
  };
  SolverSettings<Whole<Sand>> plain;
  auto whole = block(Space(), plain);
  auto const log = run(whole);
  CHECK(log.size() > 30);
  for (int ranks : {1, 2, 3, 4}) {
    std::vector<std::vector<double>> logs(static_cast<std::size_t>(ranks));
    std::uint64_t hash = 0;
    run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) {
      SolverSettings<OnRanks<Sand>> settings;
      settings.ranks.team = team;
      auto solver = block(space, settings);
      logs[std::size_t(team.rank())] = run(solver);
      auto const found = state_hash(solver);
      if (team.rank() == 0) hash = found;
    });
    for (auto const& each : logs) CHECK(each == log);
    CHECK(hash == state_hash(whole));
  }
}

TEST_CASE("particles that overlap with those of another rank are refused on all ranks") {
  auto const overlapping = [](int ranks) {
    run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) {
      SolverSettings<OnRanks<Sand>> settings;
      settings.ranks = {.team = team, .slabs = 0};
      settings.spacing = dr;
      settings.physics = weightless();
      Solver<OnRanks<Sand>> solver(space, settings, fill_lattice(Box<2>{{0, 0}, {1.6, 0.8}}, dr));
      for (int step = 0; step < 5; ++step) solver.step(1);
      solver.add({{1.55, 0.452}});
    });
  };
  for (int ranks : {1, 3}) CHECK_THROWS_WITH(overlapping(ranks), ContainsSubstring("those that are there"));
}

}  // namespace scree::test::openings_tests
