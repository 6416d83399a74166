// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/granular.hpp>
#include <scree/granular/wall_forces.hpp>
#include <scree/laws/hypoplastic.hpp>
#include <scree/motion/motion_of_groups.hpp>
#include <scree/solver/load_control.hpp>

#include <laws/hochstetten.hpp>
#include <support/formulations.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <memory>

namespace scree::test::load_control_tests {
using namespace fields;
namespace {
using Catch::Matchers::ContainsSubstring;

struct Hypoplasticity : GranularModels {
  using law = Hypoplastic;
};
double const dr = 0.01;  // m
template <class Q>
using Sand = Formulated<Q, Granular<>, MotionOfGroups<2, Steered<Q::dim>>, WallForces>;

template <int Dim>
Vec<Dim, double> downwards() {
  Vec<Dim, double> x = zero<Vec<Dim, double>>();
  x[Dim - 1] = -1;
  return x;
}
/// A weightless layer on a floor, and a plate on it; periods to the sides.
template <class Q>
struct Pressed {
  static constexpr int dim = Q::dim;
  using X = Vec<dim, double>;
  using S = Solver<Sand<Q>>;
  static constexpr double side = 0.06, height = 0.05;
  Groups<dim> walls;
  S solver;
  std::shared_ptr<LoadControl<S>> control;

  Pressed() : walls(groups()), solver(make(walls)), control(controlled(solver, walls)) { solver.attach(control); }
  static Box<dim> layer(double low, double high) {
    Box<dim> box{zero<X>(), X::Constant(side)};
    box.low[dim - 1] = low, box.high[dim - 1] = high;
    return box;
  }
  static Groups<dim> groups() {
    return Groups<dim>()
        .add("floor", fill_lattice(layer(-3 * dr, 0), dr))
        .add("plate", fill_lattice(layer(height, height + 3 * dr), dr));
  }
  static S make(Groups<dim> const& walls) {
    Granular<> physics;
    physics.law.elastic = {1e6, 0.4, 1500};
    physics.law.grains = {1e-3};
    physics.gravity = {0};
    SolverSettings<Sand<Q>> settings{.spacing = dr, .physics = physics};
    settings.motion = MotionOfGroups<2, Steered<dim>>(walls);
    for (int axis = 0; axis + 1 < dim; ++axis) settings.periods.push_back({axis, 0, side});
    return S(settings, cast<typename Q::real>(fill_lattice(layer(0, height), dr)), walls);
  }
  static std::shared_ptr<LoadControl<S>> controlled(S const& solver, Groups<dim> const& walls) {
    return std::make_shared<LoadControl<S>>(
        solver, walls,
        ControlledLoad<dim>{.group = "plate",
                            .direction = 3 * downwards<dim>(),
                            .area = std::pow(side, dim - 1),
                            .pressure = [](double time) { return time < 0.1 ? 2e3 : 4e3; }});
  }
};
template <int Dim, class Real>
using On = Policy<Dim, Real, Kokkos::DefaultHostExecutionSpace>;

}  // namespace

TEMPLATE_TEST_CASE("a plate presses as it is told", "", (On<2, double>), (On<2, float>), (On<3, double>)) {
  Pressed<TestType> cell;
  auto& now = cell.solver;
  auto const floor = [&] {
    return wall_load(now, cell.walls, "floor").force.dot(downwards<TestType::dim>()) /
           std::pow(cell.side, TestType::dim - 1);
  };
  now.run(0.1);
  CHECK(std::abs(cell.control->pressure() / 2e3 - 1) < 0.005);
  CHECK(std::abs(floor() / 2e3 - 1) < 0.005);
  double const way = cell.control->way(now.time());
  now.run(0.25);
  CHECK(std::abs(cell.control->pressure() / 4e3 - 1) < 0.005);
  CHECK(std::abs(floor() / 4e3 - 1) < 0.005);
  CHECK(cell.control->way(now.time()) > way + 2e3 * cell.height / 2.2e6);  // stiffness 2.14 MPa
}

TEST_CASE("walls have the velocity of a new motion at once") {
  Pressed<On<2, double>> cell;
  auto motion = cell.solver.settings().motion;
  motion.set(cell.walls.number("plate"), Steered<2>{}.turned_to({0, -0.25}, 0));
  cell.solver.set_motion(motion);
  auto const u = cell.solver.wall().to_host(velocity);
  CHECK(u.front() == Vec<2, double>(0, 0));  // the floor
  CHECK(u.back() == Vec<2, double>(0, -0.25));
}

TEMPLATE_TEST_CASE("a controlled load goes on from a snapshot bit for bit", "", (On<2, double>), (On<2, float>)) {
  Pressed<TestType> whole;
  std::vector<Snapshot> snapshots = {whole.solver.snapshot()};
  whole.solver.run(
      0.06, {every<typename Pressed<TestType>::S>(0.013, [&](auto& now) { snapshots.push_back(now.snapshot()); })});
  for (auto const& snapshot : snapshots) {
    Pressed<TestType> second;
    second.solver.restore(snapshot);
    second.solver.run(0.06, {every<typename Pressed<TestType>::S>(0.013, [](auto&) {})});
    CHECK(second.control->pressure() == whole.control->pressure());
    CHECK(second.control->way(0.06) == whole.control->way(0.06));
    CHECK(second.solver.material().to_host(stress) == whole.solver.material().to_host(stress));
  }
  auto wrong = snapshots.back();
  wrong.time = 0.001;
  Pressed<TestType> third;
  CHECK_THROWS_WITH(third.solver.restore(wrong), ContainsSubstring("a load on plate that changed at"));
}

TEST_CASE("several controlled loads go on from a snapshot together") {
  using Cell = Pressed<On<2, double>>;
  auto const with_two = [](Cell& cell) {
    cell.solver.attach(std::make_shared<LoadControl<Cell::S>>(
        cell.solver, cell.walls, ControlledLoad<2>{"floor", {0, 1}, 0.06, [](double) { return 1e3; }}));
  };
  Cell whole, second;
  with_two(whole), with_two(second);
  whole.solver.run(0.01);
  auto const snapshot = whole.solver.snapshot();
  second.solver.restore(snapshot);
  CHECK(second.solver.snapshot() == snapshot);
  whole.solver.run(0.02), second.solver.run(0.02);
  CHECK(second.solver.snapshot() == whole.solver.snapshot());
}

TEST_CASE("a load takes a wall over where it is and with its velocity") {
  using Cell = Pressed<On<2, double>>;
  Cell cell;
  auto const plate = cell.walls.number("plate");
  auto motion = cell.solver.settings().motion;
  motion.set(plate, Steered<2>{}.turned_to({0, 0.02}, 0));
  Cell::S lifted({.spacing = dr,
                  .physics = cell.solver.settings().physics,
                  .motion = motion,
                  .periods = cell.solver.settings().periods},
                 fill_lattice(Cell::layer(0, Cell::height), dr), cell.walls);
  lifted.run(0.01);
  auto const control = Cell::controlled(lifted, cell.walls);
  lifted.attach(control);
  CHECK(std::abs(lifted.wall().to_host(velocity).back()[1] - 0.02) < 1e-15);
  lifted.step(1);
  CHECK(std::abs(control->way(lifted.time()) + 2e-4) < 1e-5);  // upwards, from 0.2 mm on
}

TEST_CASE("a new motion is that of as many groups") {
  Pressed<On<2, double>> cell;
  CHECK_THROWS_WITH(cell.solver.set_motion({}), ContainsSubstring("0 groups, and the wall has 2"));
}

TEST_CASE("a controlled load is refused with its range") {
  using Cell = Pressed<On<2, double>>;
  Cell cell;
  auto const message = [&](ControlledLoad<2> const& settings) {
    try {
      LoadControl<Cell::S> const control(cell.solver, cell.walls, settings);
    } catch (std::invalid_argument const& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  auto const pressure = [](double) { return 1e3; };
  CHECK(message({"plate", {0, -1}, 0.06, pressure}).empty());
  CHECK_THAT(message({"lid", {0, -1}, 0.06, pressure}), ContainsSubstring("'lid'"));
  CHECK_THAT(message({"plate", {0, 0}, 0.06, pressure}), ContainsSubstring("length of the direction"));
  CHECK_THAT(message({"plate", {0, -1}, 0, pressure}), ContainsSubstring("area (m^(dim-1))"));
  CHECK_THAT(message({"plate", {0, -1}, 0.06, {}}), ContainsSubstring("`pressure`"));
  CHECK_THAT(message({"plate", {0, -1}, 0.06, pressure, -1}), ContainsSubstring("sound_speed (m/s)"));
  CHECK_THROWS_WITH(
      (LoadControl<Cell::S>(cell.solver, Groups<2>(cell.walls).add("lid", {{1, 1}}), {"lid", {0, -1}, 0.06, pressure})),
      ContainsSubstring("2, as the motion has"));
  Cell other;
  other.solver.attach(std::make_shared<LoadControl<Cell::S>>(
      other.solver, other.walls, ControlledLoad<2>{"plate", {0, -1}, 0.06, [](double) { return -5.0; }}));
  CHECK_THROWS_WITH(other.solver.run(0.01), ContainsSubstring("pressure (Pa) of a controlled load"));
}

TEST_CASE("a law whose speed of sound follows the stress needs one") {
  using Q = On<2, double>;
  using F = Formulated<Q, Granular<Hypoplasticity>, Steered<2>, WallForces>;
  using Cell = Pressed<Q>;
  Granular<Hypoplasticity> physics;
  physics.law = hochstetten();
  Solver<F> const solver({.spacing = dr, .physics = physics}, fill_lattice(Cell::layer(0, Cell::height), dr),
                         Cell::groups());
  Groups<2> const plate = Groups<2>().add("plate", fill_lattice(Cell::layer(Cell::height, Cell::height + 3 * dr), dr));
  ControlledLoad<2> settings{"plate", {0, -1}, 0.06, [](double) { return 1e3; }};
  CHECK_THROWS_WITH((LoadControl<Solver<F>>(solver, plate, settings)), ContainsSubstring("it must be given"));
  settings.sound_speed = 100;
  CHECK_NOTHROW(LoadControl<Solver<F>>(solver, plate, settings));
  CHECK_THROWS_WITH((LoadControl<Solver<F>>(solver, Cell::groups(), settings)),
                    ContainsSubstring("one motion for all"));
}

}  // namespace scree::test::load_control_tests
