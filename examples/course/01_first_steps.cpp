// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// First steps: a ball of sand drops into a box and comes to rest as a heap.
//
//   course_01_first_steps [duration in s]
//
// In ParaView, colour particles.vtkhdf by the magnitude of velocity or by pressure. The table heap.csv has the force on
// the walls, which peaks at the impact and then settles at the weight of the sand, and the pressure below the heap.
#include <scree/granular/granular.hpp>
#include <scree/granular/wall_forces.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/probes/points.hpp>
#include <scree/run/argument.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>
#include <scree/solver/wall_loads.hpp>

#include <fmt/core.h>

using namespace scree;

// The choices made at compile time. Each part that is not named has a default.
struct Grains : GranularModels {
  using law = VolumeMemory<MuOfI<>>;         // the friction law mu(I)
  using volume_control = VolumeConsistency;  // the pressure follows the packing; for impacts of grains
};
struct Sand : Formulation<2> {  // two dimensions, double precision
  using physics = Granular<Grains>;
  using diagnostics = WallForces;  // the force on the walls, for output only
};
using S = Solver<Sand>;

int main(int argc, char** argv) {
  Kokkos::ScopeGuard const kokkos(argc, argv);
  double const duration = argument<double>(argc, argv, 1, 1);  // s
  double const radius = 0.05, width = 0.2, dr = 0.004;         // ball, box and particle spacing, m

  // Particles on a lattice: the ball, and a box as a group of wall particles, three rows thick. The ball is shifted off
  // the symmetry axis of the lattice: if its halves were equal, nothing would push its middle column aside.
  auto const ball = fill_lattice(Ball<2>{.centre = {width / 2 + 0.3 * dr, 1.5 * radius}, .radius = radius}, dr);
  Groups<2> walls;
  walls.add("box", fill_between(Box<2>{{0, 0}, {width, 1}}, Box<2>{{-3 * dr, -3 * dr}, {width + 3 * dr, 0.1}}, dr));

  // The material is far softer than real sand, because the speed of elastic waves limits the time step.
  MuOfI<> const sand{.elastic = {.young = 2e5, .poisson = 0.3, .rest_density = 1500}, .grains = {.diameter = 1e-3}};
  S box({.spacing = dr, .physics = {.law = {sand}}}, ball, walls);

  double const weight = sand.density() * 9.81 * double(ball.size()) * dr * dr;  // N per metre of depth
  CsvSeries table("heap.csv", {{"time", "s"}, {"force on the walls over weight"}, {"pressure below the heap", "Pa"}});
  BodySeries output("particles.vtkhdf", Fields<Velocity, Stress, Pressure>{}, Bodies<Material, Wall>{},
                    {.overwrite = true});
  double force = 0;  // N per metre of depth
  box.run(duration, {every<S>(duration / 100, [&](S& now) {
            output.append(now);
            force = -wall_load(now, walls, "box").force[1];
            double const below = mean_at(now, fields::pressure, {{width / 2, 0}})[0].value;  // NaN if there is no sand
            table.row({now.time(), force / weight, below});
          })});
  fmt::print(
      "after {:g} s the walls bear {:.3f} of the weight of the sand; heap.csv and particles.vtkhdf are written\n",
      box.time(), force / weight);
}
