// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// A component on several ranks of a case: each has its own, and all of them decide alike.
#include "on_ranks.hpp"

#include <scree/granular/granular.hpp>
#include <scree/granular/wall_forces.hpp>
#include <scree/motion/motion_of_groups.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/load_control.hpp>

#include <support/policies.hpp>

#include <cmath>
#include <memory>

namespace scree::test::load_control_on_ranks_tests {
namespace {

double const dr = 0.01, side = 0.12, height = 0.06;  // m

struct Pressed : Formulation<2> {
  using space = Space;
  using physics = Granular<>;
  using motion = MotionOfGroups<2, Steered<2>>;
  using diagnostics = WallForces;
};
struct End {
  std::uint64_t hash = 0;
  double pressure = 0, way = 0;
  std::int64_t ghosts = 0;
  Snapshot snapshot = {};
};
/// The runs up to these times (s), after a snapshot of an earlier run if there is one.
End pressed_on(int ranks, std::vector<double> const& times, Snapshot const* earlier = nullptr) {
  using S = Solver<OnRanks<Pressed>>;
  End result;
  run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) {
    Groups<2> walls;
    walls.add("box", wall_around(Box<2>{{0, 0}, {side, 0.2}}, dr, 3));
    walls.add("plate", fill_lattice(Box<2>{{0, height}, {side, height + 3 * dr}}, dr));
    S solver(space,
             {.spacing = dr,
              .physics = {.law = {.elastic = {1e6, 0.4, 1500}, .grains = {1e-3}}},
              .motion = MotionOfGroups<2, Steered<2>>(walls),
              .ranks = {.team = team}},
             fill_lattice(Box<2>{{0, 0}, {side, height}}, dr), walls);
    auto const control = std::make_shared<LoadControl<S>>(
        solver, walls,
        ControlledLoad<2>{
            .group = "plate", .direction = {0, -1}, .area = side, .pressure = [](double t) { return 2e3 + 1e5 * t; }});
    solver.attach(control);
    if (earlier) solver.restore(*earlier);
    for (double const time : times) solver.run(time);
    auto const hash = state_hash(solver);
    auto const ghosts = team.sum(solver.ranks().counts().ghosts);
    auto const snapshot = solver.snapshot();
    if (team.rank() == 0) result = {hash, control->pressure(), control->way(solver.time()), ghosts, snapshot};
  });
  return result;
}

}  // namespace

TEST_CASE("a controlled load has the same bits on any number of ranks, and after a restart on another number") {
  auto const one = pressed_on(1, {0.01, 0.02});
  CHECK(one.pressure > 3000);
  auto const same = [&](End const& other) {
    return other.hash == one.hash && other.pressure == one.pressure && other.way == one.way;
  };
  for (int const ranks : {2, 3}) {
    INFO(ranks << " ranks");
    auto const several = pressed_on(ranks, {0.01, 0.02});
    CHECK(several.ghosts > 0);
    CHECK(same(several));
  }
  auto const half = pressed_on(2, {0.01});
  CHECK(half.way < one.way);
  CHECK(same(pressed_on(3, {0.02}, &half.snapshot)));
}

}  // namespace scree::test::load_control_on_ranks_tests
