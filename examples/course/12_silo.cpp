// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Grains that leave the domain: a gate opens a slot in the floor of a filled silo, and the grains that fall out are
// removed and counted.
//
//   course_12_silo [width of the slot in m] [duration in s]
//
// In ParaView, particles.vtkhdf coloured by velocity shows how the bed rests, the gate takes 0.1 s to drop out of the
// way, and the silo empties through the slot. In silo.csv the mass that has left grows at a constant rate while the bed
// is high, and mass in + mass out is constant to rounding error.
#include <scree/granular/granular.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/motion/motion_of_groups.hpp>
#include <scree/motion/tabulated.hpp>
#include <scree/openings/regions.hpp>
#include <scree/run/argument.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

using namespace scree;

using Slide = Tabulated<2, 2>;  // a table of two displacements in the plane

struct Silo : Formulation<2> {
  using physics = Granular<>;
  using motion = MotionOfGroups<5, Slide>;  // up to five groups
  using integrator = SymplecticEuler;       // for long runs: a sixth of the default's run time, at three times its step
};
using S = Solver<Silo>;

int main(int argc, char** argv) {
  using namespace scree::fields;
  Kokkos::ScopeGuard const kokkos(argc, argv);
  double const slot = argument<double>(argc, argv, 1, 0.03);
  double const duration = argument<double>(argc, argv, 2, 1);
  double const width = 0.12, height = 0.15, dr = 0.003, rho = 1500, opens = 0.1;  // m, kg/m^3, s

  double const left = (width - slot) / 2, right = left + slot, thick = 3 * dr;
  Groups<2> walls;
  walls.add("floor, left", fill_lattice(Box<2>{{-thick, -thick}, {left, 0}}, dr));
  walls.add("floor, right", fill_lattice(Box<2>{{right, -thick}, {width + thick, 0}}, dr));
  walls.add("left side", fill_lattice(Box<2>{{-thick, 0}, {0, 1.2 * height}}, dr));
  walls.add("right side", fill_lattice(Box<2>{{width, 0}, {width + thick, 1.2 * height}}, dr));
  walls.add("gate", fill_lattice(Box<2>{{left, -thick}, {right, 0}}, dr));
  MotionOfGroups<5, Slide> motion(walls);
  Vec<2, double> const aside(0, -2 * width);  // down and out of the way of the grains
  motion.set(walls.number("gate"), Slide({opens, opens + 0.1}, {Vec<2, double>(0, 0), aside}));

  MuOfI<> const sand{.elastic = {.young = 3e5, .poisson = 0.3, .rest_density = rho}, .grains = {.diameter = 1e-3}};
  S solver({.spacing = dr, .physics = {.law = sand, .cfl = 0.6}, .motion = motion},
           fill_lattice(Box<2>{{0, 0}, {width, height}}, dr), walls);
  Geostatic const at_rest{height, rho, 9.81, 0.75};
  solver.set(stress, [&](auto const& x) { return packed<2>(Mat<3, double>(at_rest(x))); });

  BodySeries output("particles.vtkhdf", Fields<Velocity, Stress>{}, Bodies<Material, Wall>{}, {.overwrite = true});
  CsvSeries table("silo.csv", {{"time", "s"}, {"mass in", "kg/m"}, {"mass out", "kg/m"}, {"removed", "1"}});
  double out = 0;
  solver.drain({.name = "below", .reach = dr / 2}, Beyond<2>{{0, -10 * dr}, {0, -1}}, Fields<Volume>{},
               [&](double /*time*/, auto const& fallen) {
                 for (auto const& grain : fallen) out += rho * grain[volume];
               });
  solver.run(duration, {every<S>(0.01,
                                 [&](S& now) {
                                   double in = 0;
                                   for (double const V : now.material().to_host(volume)) in += rho * V;
                                   table.row({now.time(), in, out, double(now.turnover().removed)});
                                 }),
                        every<S>(duration / 50, [&](S& now) { output.append(now); })});
}
