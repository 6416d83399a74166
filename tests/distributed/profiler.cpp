// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "on_ranks.hpp"

#include <scree/distributed/link.hpp>
#include <scree/distributed/place.hpp>
#include <scree/distributed/profiler.hpp>
#include <scree/granular/granular.hpp>
#include <scree/setup/setup.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::profiler_tests {
namespace {

struct Collapse : Formulation<2> {
  using physics = Granular<>;
};
auto const bed = fill_lattice(Box<2>{{0, 0}, {0.2, 0.2}}, 0.01);

template <class F>
Solver<F> column(Space const& space, SolverSettings<F> settings) {
  settings.spacing = 0.01;
  settings.physics.law = {.elastic = {1e5, 0.3, 1500}, .grains = {5e-4}};
  return Solver<F>(space, settings, bed, wall_around(Box<2>{{0, 0}, {0.4, 0.5}}, 0.01, 3));
}
std::vector<RankProfile> profiles_on(int ranks, int before, int steps) {
  std::vector<RankProfile> profiles;
  run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) {
    SolverSettings<OnRanks<Collapse>> settings;
    settings.ranks.team = team;
    auto solver = column(space, settings);
    for (int k = 0; k < before; ++k) solver.step(1);
    Profiler const profiler(solver);
    for (int k = 0; k < steps; ++k) solver.step(1);
    auto const found = profiler.of(solver);
    if (team.rank() == 1 % ranks) profiles = found;
  });
  return profiles;
}

TEST_CASE("a profile counts steps, particles, messages and bytes of each rank") {
  auto const one = profiles_on(1, 20, 30), three = profiles_on(3, 20, 30);
  REQUIRE(one.size() == 1);
  REQUIRE(three.size() == 3);
  CHECK(one[0].steps == 30);
  CHECK(one[0].traffic.messages == 0);
  CHECK(one[0].traffic.bytes == 0);
  std::int64_t particles = 0;
  for (RankProfile const& rank : three) {
    INFO(rank.particles << " particles, " << rank.ghosts << " ghosts, " << rank.traffic.exchanges << " exchanges");
    particles += rank.particles;
    CHECK(rank.steps == 30);
    CHECK(rank.ghosts > 10);
    // The midpoint scheme evaluates the rates twice in a step, from several fields of neighbours.
    CHECK(rank.traffic.exchanges >= 2 * 30);
    CHECK(rank.traffic.messages >= rank.traffic.exchanges);
    // Each ghost needs two coordinates at least once in a step.
    CHECK(rank.traffic.bytes >= 30 * 2 * std::int64_t(sizeof(double)) * 10);
    CHECK(rank.traffic.exchanging + rank.traffic.gathering < rank.seconds);
    CHECK(rank.traffic.exchanging > 0);
  }
  CHECK(particles == one[0].particles);
}

TEST_CASE("each pass sends one message to each neighbour, for all bodies, and each field once in a list of passes") {
  int steps = 0, wrong = 0;
  run_on_threads<Space>(2, [&](Team<Space> const& team, Space const& space) {
    SolverSettings<OnRanks<Collapse>> settings;
    settings.ranks.team = team;
    settings.physics.filter.period = 1000;  // a filter is a pass more
    auto solver = column(space, settings);
    solver.step(1);
    int checked = 0, different = 0;
    for (int k = 0; k < 30; ++k) {
      Traffic const before = team.traffic();
      long const builds = solver.neighbour_builds();
      solver.step(1);
      if (solver.neighbour_builds() > builds) continue;
      ++checked;
      // Twice in a step: walls read the material, then the material reads both. A ghost of the material gets nine
      // numbers: position, volume, stress and velocity; one of a wall ten more, for two velocities that it shows
      // instead of one, a gradient of four numbers, a force and a normal.
      auto const numbers = team.gather(9 * solver.material().ghosts() + 19 * solver.wall().ghosts());
      std::int64_t const sent = 2 * std::int64_t(sizeof(double)) * numbers[1 - std::size_t(team.rank())];
      if (team.traffic().messages - before.messages != 4 || team.traffic().exchanges - before.exchanges != 4 ||
          team.traffic().bytes - before.bytes != sent)
        ++different;
    }
    if (team.rank() == 1) steps = checked, wrong = different;
  });
  CHECK(steps > 5);
  CHECK(wrong == 0);
}

TEST_CASE("a profile begins where its profiler was made") {
  auto const late = profiles_on(2, 40, 10), early = profiles_on(2, 0, 50);
  CHECK(late[0].steps == 10);
  CHECK(late[0].traffic.bytes < early[0].traffic.bytes / 3);
}

TEST_CASE("the link between ranks is measured, and each rank has its place") {
  for (int ranks : {1, 2, 3})
    run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) {
      Link const link = measured_link(team, space);
      auto const same = team.gather(link.latency);
      Place const place = place_of(space);
      auto const threads = team.gather(place.threads + int(place.device[0] != '\0'));
      if (team.rank() != 0) return;
      CHECK(link.latency > 0);
      CHECK(link.latency < 0.1);
      CHECK(link.bandwidth > 1e6);
      for (double const each : same) CHECK(each == link.latency);
      for (int const each : threads) CHECK(each > 0);
      CHECK(place.host[0] != '\0');
    });
}

}  // namespace
}  // namespace scree::test::profiler_tests
