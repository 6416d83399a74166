// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "granular.hpp"

#include <scree/granular/wall_forces.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/motion/motion_of_groups.hpp>
#include <scree/motion/tabulated.hpp>
#include <scree/solver/slip.hpp>
#include <scree/solver/wall_loads.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

// A gate, one of the two smooth sides of a box, is lifted at 0.1 s; the other walls are at rest.
namespace scree::test::gate {
namespace {

using X = Vec<2, double>;
using Motion = MotionOfGroups<3, Tabulated<2, 2>>;

struct Box : Formulation<2> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Granular<>;
  using motion = Motion;
  using integrator = SymplecticEuler;
  using diagnostics = WallForces;
};

double const dr = 5e-3, width = 0.1, depth = 0.1;                         // m
double const opens = 0.1, open = 0.15, lift = 0.2;                        // s, s, m
double const K0 = 0.75, push = K0 * bed_density * g * depth * depth / 2;  // N/m, of the bed against each side

Groups<2> walls() {
  double const thick = 4 * dr, top = depth + 8 * dr;
  return Groups<2>()
      .add("floor", fill_lattice(scree::Box<2>{{-thick, -thick}, {0.5, 0}}, dr))
      .add("side", fill_lattice(scree::Box<2>{{-thick, 0}, {0, top}}, dr))
      .add("gate", fill_lattice(scree::Box<2>{{width, 0}, {width + thick, top}}, dr));
}
Solver<Box> at_rest() {
  auto const wall = walls();
  Motion motion(wall);
  motion.set(wall.number("gate"), Tabulated<2, 2>({opens, open}, {X(0, 0), X(0, lift)}));
  Granular<> physics;
  physics.law.elastic = {3e5, poisson, bed_density};
  physics.law.grains = {0.5e-3};
  Solver<Box> solver({.spacing = dr, .physics = physics, .motion = motion},
                     fill_lattice(scree::Box<2>{{0, 0}, {width, depth}}, dr), wall);
  solver.set(fields::stress, [](X const& x) { return packed_stress(Geostatic{depth, bed_density, g, K0}, x); });
  set_slip(solver, wall, "side", X(1, 0));
  set_slip(solver, wall, "gate", X(-1, 0));
  return solver;
}
double fastest(Solver<Box> const& solver) {
  double most = 0;
  for (X const& u : solver.material().to_host(fields::velocity)) most = std::max(most, u.norm());
  return most;
}
double front(Solver<Box> const& solver) {
  double most = 0;
  for (X const& x : solver.material().to_host(fields::position)) most = std::max(most, x[0]);
  return most;
}

}  // namespace

TEST_CASE("a gate holds the push of the bed until it opens at 0.1 s, and then the grains flow out") {
  using namespace fields;
  auto const wall = walls();
  auto solver = at_rest();
  auto const rest = solver.wall().to_host(position);
  for (double const until : {0.03, 0.06, opens}) {
    solver.run(until);
    auto const loads = wall_loads(solver, wall, X(width, 0));
    auto const &side = loads[1], &gate = loads[2];
    INFO(until << " s: side " << side.force.transpose() / push << ", gate " << gate.force.transpose() / push
               << " of the push, moment " << gate.moment / (push * depth / 3) << ", speed " << fastest(solver)
               << " m/s");
    CHECK(gate.name == "gate");
    // The floor takes a part of the push of the two lowest rows: some 0.3 rows of 20, twice the mean pressure.
    CHECK(std::abs(gate.force[0] / push - 1) < 0.04);
    CHECK(std::abs(gate.force[1]) < 1e-3 * push);
    CHECK(std::abs(gate.force[0] + side.force[0]) < 1e-9 * push);
    CHECK(std::abs(gate.moment / (push * depth / 3) + 1) < 0.04);  // about its foot
    CHECK(gate.power == 0);
    CHECK(fastest(solver) < 1e-3);
    CHECK(solver.wall().to_host(position) == rest);
    CHECK(is_packed_as_at_rest(show_packing(solver)));
  }
  solver.run(0.125);
  auto const half_open = solver.wall().to_host(position);
  solver.run(0.3);
  auto const now = solver.wall().to_host(position);
  auto const range = wall.range("gate");
  for (int w = 0; w < solver.wall().size(); ++w) {
    auto const k = static_cast<std::size_t>(w);
    X const up(0, range.contains(w) ? lift : 0);
    REQUIRE((half_open[k] - rest[k] - up / 2).norm() < 1e-15);
    REQUIRE((now[k] - rest[k] - up).norm() < 1e-15);
  }
  show_packing(solver);
  CHECK(front(solver) > width + 0.1);
  CHECK(fastest(solver) > 0.5);
  CHECK(wall_load(solver, wall, "gate").force == X(0, 0));  // above all grains
  CHECK(wall_load(solver, wall, "side").force[0] < -0.3 * push);
  CHECK(solver.lost() == 0);
}

}  // namespace scree::test::gate
