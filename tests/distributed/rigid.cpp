// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "on_ranks.hpp"

#include <support/folder.hpp>
#include <support/formulations.hpp>

#include <scree/granular/granular.hpp>
#include <scree/granular/wall_forces.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/integrators/velocity_verlet.hpp>
#include <scree/io/rigid_series.hpp>
#include <scree/rigid/measured_mass.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/wall_loads.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

// Rigid bodies whose particles are divided among the ranks of a case.
namespace scree::test::rigid_tests {
using namespace fields;
namespace {

using Catch::Matchers::ContainsSubstring;

struct Stone : RigidBody {
  static constexpr std::string_view name = "stone";
};
template <int Dim, class Real, class Integrator>
struct Sand : Formulation<Dim, Real> {
  using space = Space;
  using physics = Granular<>;
  using bodies = Bodies<Material, Wall, Stone>;
  using integrator = Integrator;
  using diagnostics = WallForces;
};

/// A bed of sand in a trough, and what is on it.
template <class F>
struct Bed {
  static constexpr int dim = F::dim;
  double spacing = 0.02;  // m
  Box<dim> sand, room;
  Groups<dim> stones = {};
  RigidBodies<dim> rigid = {};

  template <class S>
  void add(S const& shape, double rho, Rigid<dim> body = {}) {
    stones.add("stone " + std::to_string(rigid.bodies.size()), fill_lattice(shape, spacing));
    body.properties = mass_properties(shape, rho, spacing);
    rigid.bodies.push_back(body);
  }
  Solver<F> solver(Space const& space, SolverSettings<F> settings) const {
    using real = typename F::real;
    settings.spacing = spacing;
    settings.physics.law = {.elastic = {1e5, 0.3, 1500}, .grains = {1e-3}};
    settings.physics.filter.period = 7;
    settings.rigid = rigid;
    double const top = sand.high[dim - 1];
    auto const fill = cast<real>(fill_lattice(sand, spacing)), wall = cast<real>(walls(settings.periods));
    Solver<F> made(space, settings, particles_of<Material>(fill), particles_of<Wall>(wall),
                   particles_of<Stone>(stones));
    made.set(stress, [=](auto const& x) {
      value_t<F, Stress> s = value_t<F, Stress>::Zero();
      for (int k = 0; k < 3; ++k) s[k] = real(-1500 * 9.81 * 0.7) * (real(top) - x[dim - 1]);
      return s;
    });
    return made;
  }
  /// The walls around the room; along periods there are none.
  Points<dim> walls(std::vector<Period> const& periods) const {
    Box<dim> around = room;
    for (Period const& period : periods)
      around.low[period.axis] -= 10 * spacing, around.high[period.axis] += 10 * spacing;
    Points<dim> kept;
    for (auto const& x : wall_around(around, spacing, 3))
      if (std::all_of(periods.begin(), periods.end(), [&](Period const& period) {
            return x[period.axis] > period.low && x[period.axis] < period.high;
          }))
        kept.push_back(x);
    return kept;
  }
};

/// A block that sinks a little into sand.
struct Settling : Sand<2, double, VelocityVerlet> {};
template <class F>
Solver<F> block_on_sand(Space const& space, SolverSettings<F> const& settings) {
  Bed<F> bed{.sand = {{0, 0}, {0.6, 0.16}}, .room = {{0, 0}, {0.6, 0.4}}};
  bed.add(Box<2>{{0.2, 0.16}, {0.4, 0.26}}, 1800);
  return bed.solver(space, settings);
}
/// A wheel with a given angular speed travels over sand.
struct Driven : Sand<2, double, Midpoint> {};
template <class F>
Solver<F> driven_wheel(Space const& space, SolverSettings<F> const& settings) {
  Bed<F> bed{.spacing = 0.015, .sand = {{0, 0}, {0.6, 0.1}}, .room = {{0, 0}, {0.6, 0.4}}};
  Rigid<2> wheel;
  wheel.given_turning = {-8};
  bed.add(Ball<2>{.centre = {0.2, 0.18}, .radius = 0.08}, 1000, wheel);
  return bed.solver(space, settings);
}
/// A stone falls on sand and turns, in single precision.
struct Dropped : Sand<3, float, SymplecticEuler> {};
template <class F>
Solver<F> dropped_stone(Space const& space, SolverSettings<F> const& settings) {
  Bed<F> bed{.spacing = 0.04, .sand = {{0, 0, 0}, {0.48, 0.32, 0.16}}, .room = {{0, 0, 0}, {0.48, 0.32, 0.6}}};
  Rigid<3> stone;
  stone.velocity = {0.5, 0.2, -1.5}, stone.angular_velocity = {1, 4, 2};
  bed.add(Box<3>{{0.12, 0.08, 0.18}, {0.32, 0.24, 0.3}}, 2500, stone);
  return bed.solver(space, settings);
}
/// Two stones slide over a floor into sand; the second runs into the first. A spring ties the first.
struct Colliding : Sand<2, double, SymplecticEuler> {};
template <class F>
Solver<F> two_stones(Space const& space, SolverSettings<F> const& settings, double modulus = 5e6) {
  Bed<F> bed{.spacing = 0.01, .sand = {{0.3, 0}, {0.5, 0.04}}, .room = {{0, 0}, {0.5, 0.2}}};
  bed.rigid.contact = RigidContact{.modulus = modulus, .restitution = 0.4, .friction = 0.3};
  bed.rigid.springs = {
      Spring<2>{.body = 0, .point = {0.2, 0.03}, .anchor = {0.2, 0.2}, .stiffness = 2e3, .damping = 5}};
  bed.add(Box<2>{{0.18, 0}, {0.28, 0.06}}, 2500, {.velocity = {1.5, 0}});
  bed.add(Box<2>{{0.06, 0}, {0.16, 0.08}}, 2500, {.velocity = {3, 0}});
  return bed.solver(space, settings);
}
/// A beam across a flow with two periodic directions: it has images, and moves along neither.
struct Beam : Sand<3, double, Midpoint> {};
template <class F>
Solver<F> beam_across(Space const& space, SolverSettings<F> settings) {
  Bed<F> bed{.spacing = 0.04, .sand = {{0, 0, 0}, {0.48, 0.32, 0.12}}, .room = {{0, 0, 0}, {0.48, 0.32, 0.4}}};
  settings.periods = {{1, 0, 0.32}};
  Rigid<3> beam;
  beam.given_velocity[1] = beam.given_turning[0] = beam.given_turning[2] = 0;
  beam.velocity = {1, 0, -1};
  bed.add(Box<3>{{0.12, 0, 0.14}, {0.28, 0.32, 0.26}}, 2500, beam);
  return bed.solver(space, settings);
}

std::string text_of(std::filesystem::path const& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

template <class F, class Make>
Solver<Whole<F>> check_same_bits(int steps, Make const& make, std::vector<int> const& numbers = {2, 3, 4}) {
  auto const one = outcome_on<F>(1, steps, make);
  CHECK(one.builds > 3);
  std::int64_t migrated = 0;
  for (int ranks : numbers) {
    INFO(ranks << " ranks");
    auto const several = outcome_on<F>(ranks, steps, make);
    CHECK(several.hash == one.hash);
    CHECK(several.builds == one.builds);
    migrated += several.migrated;
  }
  // With VelocityVerlet lists end within steps, and particles stay on their rank for 64 of them.
  CHECK((migrated > 0 || std::is_same_v<typename F::integrator, VelocityVerlet>));
  auto alone = make(Space(), SolverSettings<Whole<F>>());
  for (int k = 0; k < steps; ++k) alone.step(1);
  CHECK(one.hash == state_hash(alone));
  CHECK(one.time == alone.time());
  CHECK(alone.template body<RigidStates>().to_host(rigid_force)[0].norm() > 0);
  return alone;
}
/// A solver without ranks and several ranks continue each other's snapshots.
template <class F, class Make>
void check_exchange(Make const& make) {
  auto alone = make(Space(), SolverSettings<Whole<F>>()), other = make(Space(), SolverSettings<Whole<F>>());
  for (int k = 0; k < 60; ++k) alone.step(1);
  auto const of_whole = alone.snapshot(), of_ranks = snapshots_on<F>(3, {60}, make).front();
  CHECK(of_ranks.signature == of_whole.signature);
  for (int k = 0; k < 40; ++k) alone.step(1);
  CHECK(end_from<F>(of_whole, 4, 100, make) == state_hash(alone));
  other.restore(of_ranks);
  for (int k = 0; k < 40; ++k) other.step(1);
  CHECK(state_hash(other) == state_hash(alone));
}

auto const make_block = [](Space const& space, auto const& settings) { return block_on_sand(space, settings); };
auto const make_wheel = [](Space const& space, auto const& settings) { return driven_wheel(space, settings); };
auto const make_stone = [](Space const& space, auto const& settings) { return dropped_stone(space, settings); };
auto const make_stones = [](Space const& space, auto const& settings) { return two_stones(space, settings); };
auto const make_beam = [](Space const& space, auto const& settings) { return beam_across(space, settings); };

}  // namespace

TEST_CASE("a block at rest on sand has the same bits on any number of ranks, and of a solver without ranks") {
  check_same_bits<Settling>(300, make_block, {2, 3, 4, 8});
}

TEST_CASE("a driven wheel has the same bits on any number of ranks, and of a solver without ranks") {
  check_same_bits<Driven>(300, make_wheel);
}

TEST_CASE("a stone that falls on sand has the same bits on any number of ranks, and of a solver without ranks") {
  check_same_bits<Dropped>(200, make_stone);
}

TEST_CASE("two rigid bodies in contact have the same bits on any number of ranks, and of a solver without ranks") {
  auto const end = check_same_bits<Colliding>(700, make_stones);
  CHECK(end.body<RigidStates>().to_host(rigid_velocity)[0][0] > 1.6);
}

TEST_CASE("a rigid body with images has the same bits on any number of ranks, and of a solver without ranks") {
  check_same_bits<Beam>(120, make_beam);
}

TEST_CASE("the particles of a rigid body are divided, and all ranks have its state") {
  run_on_threads<Space>(3, [&](Team<Space> const& team, Space const& space) {
    SolverSettings<OnRanks<Driven>> settings;
    settings.ranks.team = team;
    auto solver = driven_wheel(space, settings);
    for (int k = 0; k < 20; ++k) solver.step(1);
    auto const sizes = team.gather(solver.body<Stone>().size());
    auto const& states = solver.body<RigidStates>();
    auto const centres = team.gather(states.to_host(rigid_centre));
    auto const found = gathered<RigidStates>(solver, rigid_centre);
    if (team.rank() != 0) return;
    CHECK(std::count(sizes.begin(), sizes.end(), 0) < 2);
    CHECK(solver.body<Stone>().everywhere() > sizes[0]);
    CHECK(states.everywhere() == 1);
    CHECK(centres == std::vector<Vec<2, double>>(3, found.at(0)));
  });
}

TEST_CASE("loads on walls and tables of rigid bodies are the same on any number of ranks") {
  Folder const folder;
  Groups<2> stones;  // for their names
  stones.add("first", {}), stones.add("second", {});
  std::vector<double> loads;
  std::vector<std::string> tables;
  for (int ranks : {1, 3}) {
    run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) {
      SolverSettings<OnRanks<Colliding>> settings;
      settings.ranks.team = team;
      auto solver = two_stones(space, settings);
      RigidSeries series(folder / std::to_string(ranks), stones);
      for (int k = 0; k < 150; ++k) {
        solver.step(1);
        if (k % 50 == 0) series.append(solver);
      }
      Groups<2> walls;
      walls.add("walls", Points<2>(std::size_t(solver.wall().everywhere())));
      auto const load = wall_load(solver, walls, "walls");
      if (team.rank() == 0) loads.push_back(load.force[1]), loads.push_back(load.moment);
    });
    tables.push_back(text_of(folder / std::to_string(ranks) / "second.csv"));
  }
  CHECK(std::count(tables.at(0).begin(), tables[0].end(), '\n') == 4);
  CHECK(tables.at(1) == tables[0]);
  CHECK(loads.at(0) < -10);
  CHECK(loads.at(2) == loads[0]);
  CHECK(loads.at(3) == loads[1]);
}

TEST_CASE("all ranks stop where rigid bodies overlap too far") {
  auto const soft = [](Space const& space, auto const& settings) { return two_stones(space, settings, 1e5); };
  CHECK_THROWS_WITH(outcome_on<Colliding>(3, 400, soft), ContainsSubstring("overlap of rigid bodies"));
}

TEST_CASE("rest positions of walls beside rigid bodies are set before a case is divided") {
  auto const run = [&](Team<Space> const& team, Space const& space) {
    SolverSettings<OnRanks<Settling>> settings;
    settings.ranks.team = team;
    auto solver = block_on_sand(space, settings);
    auto const same = [](auto const& x) { return Vec<2, double>(x); };
    solver.template set<Wall>(rest_position, same);
    solver.step(1);
    solver.template set<Wall>(rest_position, same);
  };
  CHECK_THROWS_WITH(run_on_threads<Space>(2, run), ContainsSubstring("before the first step"));
}

TEST_CASE("rigid bodies have the same snapshot on any number of ranks, and continue from it on any number") {
  check_restarts<Colliding>(make_stones, {0, 151}, 300);
}

TEST_CASE("rigid bodies on ranks and a solver of its own exchange snapshots") {
  check_exchange<Dropped>(make_stone);
  check_exchange<Beam>(make_beam);
}

}  // namespace scree::test::rigid_tests
