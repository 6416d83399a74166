// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Walls that move independently: a gate holds back a bed of grains, and is then lifted.
//
//   course_04_gate [time at which the gate opens, in s] [duration in s]
//
// In ParaView, particles.vtkhdf coloured by velocity shows grains and walls: the bed rests, the gate takes 0.05 s to
// rise, and the grains flow out. In gate.csv the force on the gate is K rho g H^2/2 before the gate rises, where K is
// the ratio of horizontal to vertical stress, and zero afterwards.
#include <scree/granular/granular.hpp>
#include <scree/granular/wall_forces.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/motion/motion_of_groups.hpp>
#include <scree/motion/tabulated.hpp>
#include <scree/run/argument.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/slip.hpp>
#include <scree/solver/solver.hpp>
#include <scree/solver/wall_loads.hpp>

using namespace scree;

using Lift = Tabulated<2, 2>;  // a table of two displacements in the plane

struct Box2 : Formulation<2> {
  using physics = Granular<>;
  using motion = MotionOfGroups<3, Lift>;  // up to three groups, each at rest or with a motion of this type
  using diagnostics = WallForces;          // the force on each wall particle, for wall_loads()
};
using S = Solver<Box2>;

int main(int argc, char** argv) {
  using namespace scree::fields;
  Kokkos::ScopeGuard const kokkos(argc, argv);
  double const opens = argument<double>(argc, argv, 1, 0.1);
  double const duration = argument<double>(argc, argv, 2, 0.6);
  double const side = 0.1, dr = 0.005, rho = 1500, K = 0.75;  // m, kg/m^3, -

  Groups<2> walls;
  walls.add("floor", fill_lattice(Box<2>{{-3 * dr, -3 * dr}, {5 * side, 0}}, dr));
  walls.add("side", fill_lattice(Box<2>{{-3 * dr, 0}, {0, 1.4 * side}}, dr));
  walls.add("gate", fill_lattice(Box<2>{{side, 0}, {side + 3 * dr, 1.4 * side}}, dr));
  MotionOfGroups<3, Lift> motion(walls);
  motion.set(walls.number("gate"), Lift({opens, opens + 0.05}, {Vec<2, double>(0, 0), Vec<2, double>(0, 2 * side)}));

  MuOfI<> const sand{.elastic = {.young = 3e5, .poisson = 0.3, .rest_density = rho}, .grains = {.diameter = 0.5e-3}};
  S solver({.spacing = dr, .physics = {.law = sand}, .motion = motion}, fill_lattice(Box<2>{{0, 0}, {side, side}}, dr),
           walls);
  set_slip(solver, walls, "side", Vec<2, double>(1, 0));
  set_slip(solver, walls, "gate", Vec<2, double>(-1, 0));
  Geostatic const at_rest{side, rho, 9.81, K};
  solver.set(stress, [&](auto const& x) { return packed<2>(Mat<3, double>(at_rest(x))); });

  BodySeries output("particles.vtkhdf", Fields<Velocity, Stress>{}, Bodies<Material, Wall>{}, {.overwrite = true});
  CsvSeries table("gate.csv", {{"time", "s"}, {"force on the gate", "N/m"}, {"force at rest", "N/m"}, {"front", "m"}});
  solver.run(duration, {every<S>(duration / 60, [&](S& now) {
               output.append(now);
               double front = 0;
               for (auto const& x : now.material().to_host(position)) front = std::max(front, x[0]);
               table.row({now.time(), wall_load(now, walls, "gate").force[0], K * rho * 9.81 * side * side / 2, front});
             })});
}
