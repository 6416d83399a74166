// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "on_ranks.hpp"

#include <support/formulations.hpp>

#include <scree/granular/granular.hpp>
#include <scree/setup/setup.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <limits>

// Failures of ranks.
namespace scree::test::faults_tests {
using namespace fields;
namespace {

using Catch::Matchers::ContainsSubstring;

struct Thrown : Formulation<2> {
  using space = Space;
  using physics = Granular<>;
};
double const dr = 0.05;
/// A block that flies to the right, without gravity.
template <class F>
Solver<F> thrown(Space const& space, SolverSettings<F> settings, double speed) {
  settings.spacing = dr;
  settings.lost_share = 1;
  settings.physics.gravity = {0};
  settings.physics.law = {.elastic = {1e4, 0.3, 1500}, .grains = {1e-3}};
  settings.physics.largest_mach = 10;
  Solver<F> solver(space, settings, fill_lattice(Box<2>{{0, 0}, {1, 0.3}}, dr),
                   fill_lattice(Box<2>{{2, 2}, {2.3, 2.1}}, dr));
  solver.set(velocity, [=](auto const&) { return Vec<2, double>(speed, 0); });
  return solver;
}
auto const flying = [](Space const& space, auto settings) { return thrown(space, settings, 5); };

}  // namespace

TEST_CASE("all particles may leave a rank", "") {
  // The ranks are slabs that stay where they are.
  DividedCase<Space> const slabs{.slabs = 0, .most_imbalance = 1e9};
  int const steps = 300;
  auto const one = outcome_on<Thrown>(1, steps, flying), three = outcome_on<Thrown>(3, steps, flying, slabs);
  CHECK(three.hash == one.hash);
  CHECK(three.sizes == std::vector<int>{0, 0, 120});
  CHECK(three.divisions == 1);
}

TEST_CASE("a case is divided again when particles have gathered on one rank", "") {
  auto const moved = outcome_on<Thrown>(3, 300, flying, {.slabs = 0, .most_imbalance = 1.5});
  CHECK(moved.hash == outcome_on<Thrown>(1, 300, flying).hash);
  CHECK(moved.divisions > 1);
  CHECK(*std::max_element(moved.sizes.begin(), moved.sizes.end()) < 80);
}

TEST_CASE("there may be more ranks than slabs fit, and ranks without particles", "") {
  auto const one = outcome_on<Thrown>(1, 40, flying), many = outcome_on<Thrown>(9, 40, flying, {.slabs = 1});
  CHECK(many.hash == one.hash);
  CHECK(std::count(many.sizes.begin(), many.sizes.end(), 0) > 2);
}

TEST_CASE("a case without material and walls in one place runs on two ranks", "") {
  auto const alone = [](Space const& space, auto settings) {
    settings.spacing = dr;
    settings.physics.law = {.elastic = {1e4, 0.3, 1500}, .grains = {1e-3}};
    return Solver<OnRanks<Thrown>>(space, settings, fill_lattice(Box<2>{{0, 0}, {dr, dr}}, dr));
  };
  CHECK(outcome_on<Thrown>(2, 5, alone).hash == outcome_on<Thrown>(1, 5, alone).hash);
}

TEST_CASE("a value that is not finite ends all ranks with its message", "") {
  auto const bad = [](Space const& space, auto settings) {
    auto solver = thrown(space, settings, 0);
    solver.set(velocity, [](auto const& x) {
      return Vec<2, double>(x[0] > 0.97 && x[1] < dr ? std::numeric_limits<double>::quiet_NaN() : 0, 0);
    });
    return solver;
  };
  for (int ranks : {1, 4})
    CHECK_THROWS_WITH(outcome_on<Thrown>(ranks, 20, bad), ContainsSubstring("particle 19 is not finite"));
}

TEST_CASE("a bound is that of all ranks", "") {
  auto const fast = [](Space const& space, auto settings) {
    settings.lost_share = 1;
    auto solver = thrown(space, settings, 0);
    solver.set(velocity, [](auto const& x) { return Vec<2, double>(x[0] > 0.5 ? 1e3 : 2e3, 0); });
    return solver;
  };
  for (int ranks : {1, 2, 4})
    CHECK_THROWS_WITH(outcome_on<Thrown>(ranks, 20, fast), ContainsSubstring("it is beyond for 120 of 120 particles"));
}

TEST_CASE("walls that are too thin are found before the case is divided, and only those", "") {
  auto const rows = [](int count) {
    return [=](Space const& space, auto settings) {
      settings.spacing = dr;
      settings.lost_share = 1;
      settings.physics.law = {.elastic = {1e4, 0.3, 1500}, .grains = {1e-3}};
      return Solver<OnRanks<Thrown>>(space, settings, fill_lattice(Box<2>{{0, 0}, {1, 0.3}}, dr),
                                     fill_lattice(Box<2>{{-1, -dr * count}, {2, 0}}, dr));
    };
  };
  // A plane between slabs divides the rows.
  CHECK(outcome_on<Thrown>(10, 300, rows(5), {.slabs = 1}).hash == outcome_on<Thrown>(1, 300, rows(5)).hash);
  CHECK_THROWS_WITH(outcome_on<Thrown>(2, 5, rows(1)), ContainsSubstring("it has one row of particles"));
}

TEST_CASE("a rank that throws in an observer ends all", "") {
  auto const run = [](int who) {
    run_on_threads<Space>(3, [&](Team<Space> const& team, Space const& space) {
      SolverSettings<OnRanks<Thrown>> settings;
      settings.ranks.team = team;
      auto solver = thrown(space, settings, 1);
      solver.run(1, {every<Solver<OnRanks<Thrown>>>(0.02, [&](auto const& now) {
                   if (now.time() > 0.01 && team.rank() == who) throw std::runtime_error("the disk is full");
                 })});
    });
  };
  for (int who : {0, 2}) CHECK_THROWS_WITH(run(who), "the disk is full");
}

TEST_CASE("settings of ranks out of their range are refused", "") {
  CHECK_THROWS_WITH(outcome_on<Thrown>(2, 1, flying, {.most_imbalance = 1}), ContainsSubstring("most_imbalance"));
  CHECK_THROWS_WITH(outcome_on<Thrown>(2, 1, flying, {.slabs = 2}), ContainsSubstring("the axis of slabs"));
  CHECK_THROWS_WITH(outcome_on<Thrown>(2, 1, flying, {.costs = {0}}), ContainsSubstring("the cost of a particle"));
}

}  // namespace scree::test::faults_tests
