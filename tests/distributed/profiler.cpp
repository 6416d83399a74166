// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "on_parts.hpp"

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
std::vector<PartProfile> profiles_on(int parts, int before, int steps) {
  std::vector<PartProfile> profiles;
  run_on_parts<Space>(parts, [&](Team<Space> const& team, Space const& space) {
    SolverSettings<OnParts<Collapse>> settings;
    settings.parts.team = team;
    auto solver = column(space, settings);
    for (int k = 0; k < before; ++k) solver.step(1);
    Profiler const profiler(solver);
    for (int k = 0; k < steps; ++k) solver.step(1);
    auto const found = profiler.of(solver);
    if (team.part() == 1 % parts) profiles = found;
  });
  return profiles;
}

TEST_CASE("a profile counts steps, particles, messages and bytes of each part") {
  auto const one = profiles_on(1, 20, 30), three = profiles_on(3, 20, 30);
  REQUIRE(one.size() == 1);
  REQUIRE(three.size() == 3);
  CHECK(one[0].steps == 30);
  CHECK(one[0].traffic.messages == 0);
  CHECK(one[0].traffic.bytes == 0);
  std::int64_t particles = 0;
  for (PartProfile const& part : three) {
    INFO(part.particles << " particles, " << part.ghosts << " ghosts, " << part.traffic.exchanges << " exchanges");
    particles += part.particles;
    CHECK(part.steps == 30);
    CHECK(part.ghosts > 10);
    // The midpoint scheme evaluates the rates twice in a step, from several fields of neighbours.
    CHECK(part.traffic.exchanges >= 2 * 30);
    CHECK(part.traffic.messages >= part.traffic.exchanges);
    // Each ghost needs two coordinates at least once in a step.
    CHECK(part.traffic.bytes >= 30 * 2 * std::int64_t(sizeof(double)) * 10);
    CHECK(part.traffic.exchanging + part.traffic.gathering < part.seconds);
    CHECK(part.traffic.exchanging > 0);
  }
  CHECK(particles == one[0].particles);
}

TEST_CASE("each pass sends one message to each neighbour, for all bodies, and each field once in a list of passes") {
  int steps = 0, wrong = 0;
  run_on_parts<Space>(2, [&](Team<Space> const& team, Space const& space) {
    SolverSettings<OnParts<Collapse>> settings;
    settings.parts.team = team;
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
      // Twice in a step: walls read the material, then the material reads both. Each ghost gets nine numbers: position,
      // volume, stress and velocity, of walls that of the dummy.
      auto const ghosts = team.gather(solver.material().ghosts() + solver.wall().ghosts());
      std::int64_t const sent = 2 * 9 * std::int64_t(sizeof(double)) * ghosts[1 - std::size_t(team.part())];
      if (team.traffic().messages - before.messages != 4 || team.traffic().exchanges - before.exchanges != 4 ||
          team.traffic().bytes - before.bytes != sent)
        ++different;
    }
    if (team.part() == 1) steps = checked, wrong = different;
  });
  CHECK(steps > 5);
  CHECK(wrong == 0);
}

TEST_CASE("a profile begins where its profiler was made") {
  auto const late = profiles_on(2, 40, 10), early = profiles_on(2, 0, 50);
  CHECK(late[0].steps == 10);
  CHECK(late[0].traffic.bytes < early[0].traffic.bytes / 3);
}

TEST_CASE("the link between parts is measured, and each part has its place") {
  for (int parts : {1, 2, 3})
    run_on_parts<Space>(parts, [&](Team<Space> const& team, Space const& space) {
      Link const link = measured_link(team, space);
      auto const same = team.gather(link.latency);
      Place const place = place_of(space);
      auto const threads = team.gather(place.threads + int(place.device[0] != '\0'));
      if (team.part() != 0) return;
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
