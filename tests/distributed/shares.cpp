// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "on_ranks.hpp"

#include <support/formulations.hpp>

#include <scree/granular/granular.hpp>
#include <scree/granular/wall_forces.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/set_group.hpp>
#include <scree/solver/slip.hpp>
#include <scree/solver/wall_loads.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <vector>

// Cases whose ranks begin with shares of the particles: the bits of cases that begin whole.
namespace scree::test::shares_tests {
using namespace fields;
namespace {

struct Collapse : Formulation<2> {
  using space = Space;
  using physics = Granular<>;
  using carries = Fields<Group>;
  using diagnostics = WallForces;
};
double const dr = 0.01;
Box<2> const sand_box{{0, 0}, {0.2, 0.3}}, room{{0, 0}, {0.8, 0.5}};

/// Walls in three groups, whole or a share.
template <class... OfWhom>
Groups<2> walls_of_room(OfWhom const&... share) {
  Box<2> const left{{-4 * dr, 0}, {0, 0.5}}, right{{0.8, 0}, {0.8 + 4 * dr, 0.5}};
  Groups<2> walls;
  walls.add("floor", fill_lattice(Box<2>{{-4 * dr, -4 * dr}, {0.8 + 4 * dr, 0}}, dr, share...));
  walls.add("none", {}).add("left", fill_lattice(left, dr, share...)).add("right", fill_lattice(right, dr, share...));
  return walls;
}
template <class F>
SolverSettings<F> with_soil(SolverSettings<F> settings) {
  settings.spacing = dr;
  settings.physics.law = {.elastic = {1e5, 0.3, 1500}, .grains = {5e-4}};
  settings.physics.filter.period = 7;
  return settings;
}
template <class S>
void throw_to_the_right(S& solver) {
  solver.set(velocity, [](auto const& x) { return Vec<2, double>(1, 0.1 * x[1]); });
}
using S = Solver<OnRanks<Collapse>>;
using OfRank = SolverSettings<OnRanks<Collapse>>;

S whole_column(Space const& space, OfRank const& settings) {
  S solver(space, with_soil(settings), fill_lattice(sand_box, dr), walls_of_room());
  throw_to_the_right(solver);
  return solver;
}
S shared_column(Space const& space, OfRank const& settings) {
  auto const share = settings.ranks.team->share();
  S solver(space, with_soil(settings), fill_lattice(sand_box, dr, share), walls_of_room(share));
  throw_to_the_right(solver);
  return solver;
}

struct Block : Formulation<3, float> {
  using space = Space;
  using physics = Granular<>;
};
/// A block in space, periodic along two axes.
template <class... OfWhom>
auto block_of(Space const& space, SolverSettings<OnRanks<Block>> settings, OfWhom const&... share) {
  settings.spacing = 0.1;
  settings.periods = {{0, 0, 0.9}, {1, 0, 0.9}};
  settings.physics.law = {.elastic = {1e4, 0.3, 1500}, .grains = {1e-3}};
  Box<3> const sand{{0, 0, 0}, {0.9, 0.9, 0.4}}, floor{{0, 0, -0.4}, {0.9, 0.9, 0}};
  Groups<3> bed, below;
  bed.add("sand", fill_lattice(sand, 0.1, share...));
  below.add("floor", fill_lattice(floor, 0.1, share...));
  Solver<OnRanks<Block>> solver(space, settings, bed, below);
  solver.set(velocity, [](auto const& x) { return Vec<3, float>(5 * x[2], -3 * x[2], 0); });
  return solver;
}

}  // namespace

TEST_CASE("a column that begins from shares has the bits of one that begins whole", "") {
  int const steps = 300;
  auto const one = outcome_on<Collapse>(1, steps, whole_column);
  CHECK(one.builds > 10);
  for (int ranks : {1, 2, 3, 4}) {
    INFO(ranks << " ranks");
    auto const several = outcome_on<Collapse>(ranks, steps, shared_column);
    CHECK(several.hash == one.hash);
    CHECK(several.builds == one.builds);
    CHECK(several.time == one.time);
    CHECK(several.migrated >= (ranks == 1 ? 0 : 200));
    CHECK(*std::max_element(several.sizes.begin(), several.sizes.end()) < 1.3 * 600 / ranks);
  }
  CHECK(outcome_on<Collapse>(3, steps, shared_column, {.slabs = 0, .most_imbalance = 1.05}).hash == one.hash);
}

TEST_CASE("a block in space that begins from shares has the bits of one that begins whole", "") {
  auto const one =
      outcome_on<Block>(1, 40, [](Space const& space, auto settings) { return block_of(space, settings); });
  for (int ranks : {1, 2, 3, 4}) {
    INFO(ranks << " ranks");
    auto const several = outcome_on<Block>(ranks, 40, [](Space const& space, auto settings) {
      return block_of(space, settings, settings.ranks.team->share());
    });
    CHECK(several.hash == one.hash);
    CHECK(several.builds == one.builds);
  }
}

TEST_CASE("shares may be as uneven as one likes, and empty", "") {
  auto const one = outcome_on<Collapse>(1, 100, whole_column);
  // The ranks with these numbers begin with the first tenth of the points, and with the others.
  for (auto const& [first, second] : {std::pair(0, 1), std::pair(2, 0)}) {
    auto const some_of = [first = first, second = second](int rank, auto const& points) {
      long const all = long(points.size()), cut = all / 10;
      SharedPoints<2> share{{}, 0, all};
      if (rank == first) share.points.assign(points.begin(), points.begin() + cut);
      if (rank == second) share.points.assign(points.begin() + cut, points.end()), share.first = cut;
      return share;
    };
    auto const several = outcome_on<Collapse>(4, 100, [&](Space const& space, OfRank const& settings) {
      int const rank = settings.ranks.team->rank();
      Groups<2> const whole = walls_of_room();
      Groups<2> walls;
      for (auto const& name : whole.names()) {
        auto const range = whole.range(name);
        std::vector<Vec<2, double>> const points(whole.points().begin() + range.first,
                                                 whole.points().begin() + range.last);
        walls.add(name, some_of(rank, points));
      }
      S solver(space, with_soil(settings), some_of(rank, fill_lattice(sand_box, dr)), walls);
      throw_to_the_right(solver);
      return solver;
    });
    CHECK(several.hash == one.hash);
  }
}

TEST_CASE("snapshots of a case from shares are those of one rank, from the start on", "") {
  std::vector<int> const after{0, 1, 40};
  auto const one = snapshots_on<Collapse>(1, after, whole_column);
  for (int ranks : {1, 3}) {
    INFO(ranks << " ranks");
    CHECK(snapshots_on<Collapse>(ranks, after, shared_column) == one);
    auto const end = outcome_on<Collapse>(1, 60, whole_column).hash;
    for (auto const& snapshot : one) CHECK(end_from<Collapse>(snapshot, ranks, 60, shared_column) == end);
  }
}

TEST_CASE("values and groups of a case from shares are set as those of a whole one", "") {
  // The values of the points here, one group with a field of its own, and a wall that slips.
  auto const with_values = [](Space const& space, OfRank const& settings, auto const&... share) {
    auto const sand = fill_lattice(sand_box, dr, share...);
    auto const walls = walls_of_room(share...);
    S solver(space, with_soil(settings), sand, walls);
    std::vector<Vec<2, double>> values;
    if constexpr (sizeof...(share) > 0)
      values = sand.points;
    else
      values = sand;
    for (auto& u : values) u = {1 + u[1], u[0]};
    solver.set(velocity, values, [](auto const& u) { return u; });
    set_slip(solver, walls, "floor", Vec<2, double>(0, 1));
    return solver;
  };
  auto const whole = [&](Space const& space, OfRank const& settings) { return with_values(space, settings); };
  auto const shared = [&](Space const& space, OfRank const& settings) {
    return with_values(space, settings, settings.ranks.team->share());
  };
  auto const one = outcome_on<Collapse>(1, 60, whole);
  for (int ranks : {1, 2, 4}) CHECK(outcome_on<Collapse>(ranks, 60, shared).hash == one.hash);
  CHECK(one.hash != outcome_on<Collapse>(1, 60, whole_column).hash);
}

TEST_CASE("grains that fly away from a case that began from shares are lost as in a whole one", "") {
  auto const lost_on = [](int ranks, auto const&... from_shares) {
    long lost = 0;
    run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) {
      OfRank settings;
      settings.ranks.team = team;
      settings.lost_share = 1;
      settings.physics.largest_mach = 10;
      settings = with_soil(settings);
      auto const solver_of = [&](auto const&... share) {
        Box<2> const floor{{0.1, -4 * dr}, {0.3, 0}};
        // The shares are layers, and these are not above each other.
        auto const sand = Box<2>{{0, 0}, {0.2, 0.15}} | Box<2>{{-0.2, 0.15}, {0, 0.3}};
        return S(space, settings, fill_lattice(sand, dr, share...), fill_lattice(floor, dr, share...));
      };
      auto solver = sizeof...(from_shares) > 0 ? solver_of(team.share()) : solver_of();
      solver.set(velocity, [](auto const& x) { return Vec<2, double>(x[1] > 0.1 ? 5 : -3, 0); });
      for (int k = 0; k < 100; ++k) solver.step(1);
      long const found = solver.lost();
      if (team.rank() == 0) lost = found;
    });
    return lost;
  };
  long const whole = lost_on(1);
  CHECK((whole > 10 && whole < 580));
  for (int ranks : {1, 2, 4}) CHECK(lost_on(ranks, true) == whole);
}

TEST_CASE("counts and loads of a case from shares are those of a whole one", "") {
  struct Found {
    std::vector<WallLoad<2>> loads;
    std::vector<Vec<2, double>> at_start;
    long count = 0, number = 0;
  };
  auto const found_on = [](int ranks, auto const& make, auto const& walls_of) {
    Found found;
    run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) {
      OfRank settings;
      settings.ranks.team = team;
      auto solver = make(space, settings);
      auto const at_start = gathered<Material>(solver, position);
      for (int k = 0; k < 20; ++k) solver.step(1);
      auto const loads = wall_loads(solver, walls_of(team));
      long const count = solver.ranks().count(solver.material());
      if (team.rank() == 0) found = {loads, at_start, count, solver.particles_at_start()};
    });
    return found;
  };
  auto const whole = found_on(1, whole_column, [](auto const&) { return walls_of_room(); });
  CHECK(whole.count == 600);
  for (int ranks : {1, 3, 4}) {
    INFO(ranks << " ranks");
    auto const shared = found_on(ranks, shared_column, [](auto const& team) { return walls_of_room(team.share()); });
    CHECK(shared.at_start == whole.at_start);
    CHECK((shared.count == whole.count && shared.number == whole.number));
    REQUIRE(shared.loads.size() == 4);
    for (std::size_t k = 0; k < 4; ++k) {
      CHECK(shared.loads[k].name == whole.loads[k].name);
      CHECK(shared.loads[k].force == whole.loads[k].force);
    }
  }
}

TEST_CASE("particles that are added to a case from shares have the next numbers", "") {
  auto const added = [](auto make) {
    return [make](Space const& space, OfRank const& settings) {
      S solver = make(space, settings);
      solver.add({{0.5, 0.2}, {0.5, 0.22}}, given(velocity, Vec<2, double>(0, -1)), given(group, 0));
      return solver;
    };
  };
  auto const one = outcome_on<Collapse>(1, 60, added(whole_column));
  for (int ranks : {1, 2, 3}) CHECK(outcome_on<Collapse>(ranks, 60, added(shared_column)).hash == one.hash);
}

}  // namespace scree::test::shares_tests
