// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/integrators/velocity_verlet.hpp>
#include <scree/io/checkpoint.hpp>

#include "support.hpp"

#include <support/folder.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

namespace scree::test::restart_tests {
using namespace fields;
namespace {
using Catch::Matchers::ContainsSubstring;
template <int Dim, class Real>
using OnDevice = Policy<Dim, Real, Kokkos::DefaultExecutionSpace>;
/// Without lists, whose builds a snapshot would hold.
struct FedByCells : FedSand<OnDevice<2, double>> {
  template <class P>
  using search = CellList<P>;
};

template <class S>
void require_same(S const& a, S const& b) {
  REQUIRE(a.time() == b.time());
  REQUIRE(a.material().size() == b.material().size());
  REQUIRE(a.material().to_host(identity) == b.material().to_host(identity));
  REQUIRE(a.material().to_host(held) == b.material().to_host(held));
  REQUIRE(a.material().to_host(position) == b.material().to_host(position));
  REQUIRE(a.material().to_host(velocity) == b.material().to_host(velocity));
  REQUIRE(a.material().to_host(stress) == b.material().to_host(stress));
  REQUIRE(ledger(a).entered == ledger(b).entered);
  REQUIRE(ledger(a).left == ledger(b).left);
  REQUIRE(a.entered()[0].volume == b.entered()[0].volume);
}
}  // namespace

TEMPLATE_TEST_CASE("a run with an inlet and a drain continues from any step bit for bit", "",
                   (FedSand<OnDevice<2, double>, Midpoint>), (FedSand<OnDevice<2, double>, VelocityVerlet>),
                   (FedSand<OnDevice<2, double>, SymplecticEuler>), (FedSand<OnDevice<2, float>, Midpoint>),
                   (FedSand<OnDevice<2, float>, VelocityVerlet>), (FedSand<OnDevice<2, float>, SymplecticEuler>),
                   (FedSand<OnDevice<3, double>, Midpoint>), (FedSand<OnDevice<3, float>, SymplecticEuler>)) {
  using F = TestType;
  auto whole = fed<F>();
  std::vector<Snapshot> snapshots = {whole.snapshot()};
  long removed = 0;
  double until = 0.6;
  whole.run(until, {}, [&](auto const& now) {
    // At the steps after which particles have come or gone, before them, and at some others.
    if (now.turnover().removed != removed || now.steps() % 17 == 0) snapshots.push_back(now.snapshot());
    removed = now.turnover().removed;
    return false;
  });
  REQUIRE(snapshots.size() > 5);
  REQUIRE(whole.left()[0].particles > 0);
  for (auto const& snapshot : snapshots) {
    auto second = fed<F>();
    second.restore(snapshot);
    if (snapshot.steps % 2 == 0) second.check_start();  // changes nothing
    second.run(until);
    require_same(whole, second);
    check_ledger(second);
  }
}

TEMPLATE_TEST_CASE("a run with a drain, and one with a shower of grains, continue from any step bit for bit", "",
                   (FedSand<OnDevice<2, double>, VelocityVerlet>), FedByCells) {
  using F = TestType;
  auto const falling = [](double reach) {
    auto physics = weightless();
    physics.gravity = {1};
    Solver<F> solver({.spacing = dr, .physics = physics}, fill_lattice(Box<2>{{0, -1}, {0.5, -0.5}}, dr));
    solver.set(velocity, [](auto const&) { return Vec<2, double>(0, -1); });
    solver.drain({.reach = reach}, Beyond<2>{{0, -1.2}, {0, -1}});
    if (reach == 0)
      solver.feed({.layer = fill_lattice(Box<2>{{0, 0}, {0.5, 0.1}}, dr),
                   .velocity = {0, -0.8},
                   .pushes = false,
                   .rate = 0.6 * 0.5 * 0.8});
    return solver;
  };
  for (double const reach : {0.0, 0.05, 0.15}) {
    auto whole = falling(reach);
    std::vector<Snapshot> snapshots;
    whole.run(0.5, {}, [&](auto const& now) {
      if (now.steps() % 7 == 0) snapshots.push_back(now.snapshot());
      return false;
    });
    REQUIRE(whole.left()[0].particles > 0);
    for (auto const& snapshot : snapshots) {
      auto second = falling(reach);
      second.restore(snapshot);
      if (snapshot.steps % 2 == 0) second.check_start();  // changes nothing
      second.run(0.5);
      if constexpr (!std::is_same_v<F, FedByCells>) REQUIRE(whole.neighbour_builds() == second.neighbour_builds());
      REQUIRE(whole.material().to_host(identity) == second.material().to_host(identity));
      REQUIRE(whole.material().to_host(position) == second.material().to_host(position));
      REQUIRE(ledger(whole).left == ledger(second).left);
      REQUIRE(ledger(whole).entered == ledger(second).entered);
    }
  }
}

TEST_CASE("a checkpoint file holds what inlets and drains need") {
  using F = FedSand<OnDevice<2, double>>;
  auto whole = fed<F>(), second = fed<F>();
  while (whole.steps() < 73) whole.step(1e-2);
  Folder const scratch;
  write_checkpoint(scratch / "checkpoint.h5", whole.snapshot());
  second.restore(read_checkpoint(scratch / "checkpoint.h5"));
  for (int k = 0; k < 60; ++k) whole.step(1e-2), second.step(1e-2);
  require_same(whole, second);
}

TEST_CASE("a run is not continued with other inlets or drains than it had") {
  using F = FedSand<OnDevice<2, double>>;
  auto whole = fed<F>();
  whole.run(0.3);
  auto const snapshot = whole.snapshot();
  auto const without = [](auto const& change) {
    Solver<F> solver({.spacing = dr, .physics = weightless()}, slab<2>(0, 0.8, 4));
    change(solver);
    return solver;
  };
  auto none = without([](auto&) {});
  CHECK_THROWS_WITH(none.restore(snapshot),
                    ContainsSubstring("the snapshot has 'inlet inlet'") && ContainsSubstring("this run has not"));
  auto no_drain = without([](auto& solver) { solver.feed(pushing<2>(4)); });
  CHECK_THROWS_WITH(no_drain.restore(snapshot), ContainsSubstring("the snapshot has 'drain drain'"));
  auto slower = without([](auto& solver) {
    auto inlet = pushing<2>(4);
    inlet.velocity[0] = 0.5;
    solver.feed(inlet);
    solver.drain({}, beyond<2>(1));
  });
  CHECK_THROWS_WITH(slower.restore(snapshot), ContainsSubstring("'inlet inlet' is"));
  auto more = fed<F>();
  more.drain({.name = "further"}, beyond<2>(2));
  CHECK_THROWS_WITH(more.restore(snapshot), ContainsSubstring("this run has 'drain further'"));

  auto damaged = snapshot;
  --damaged.counters["inlet inlet/layers"];
  auto second = fed<F>();
  CHECK_THROWS_WITH(second.restore(damaged), ContainsSubstring("does not follow from its rate and the time"));
  for (auto const& [counter, count] : {std::pair("openings/checked", 1L << 61), {"drain drain/particles", 1L << 61}}) {
    damaged = snapshot;
    damaged.counters[counter] = count;
    CHECK_THROWS_WITH(second.restore(damaged),
                      ContainsSubstring(std::string(counter) + "' is 2305843009213693952, and must"));
  }
  auto const unchanged = fed<F>();
  require_same(second, unchanged);
}

}  // namespace scree::test::restart_tests
