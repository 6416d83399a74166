// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// A vessel from a file: the inside of a funnel, drawn in mm, is filled with a given mass of sand.
//
//   python3 vessel.py vessel.stl && course_13_own_vessel vessel.stl [mass in kg] [spacing in mm] [duration in s]
//
// The program reports on the file: the triangles, the volume, and the thinnest wall in spacings. In particles.vtkhdf
// the sand settles in the funnel. The table vessel.csv has the force on the vessel over the weight of the given mass.
// This ratio ends at 1, because the particles have exactly this mass.
#include <scree/granular/granular.hpp>
#include <scree/granular/wall_forces.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/run/argument.hpp>
#include <scree/run/progress.hpp>
#include <scree/run/run_with.hpp>
#include <scree/setup/mesh.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>
#include <scree/solver/wall_loads.hpp>

#include <fmt/core.h>

using namespace scree;

struct Sand : Formulation<3> {
  using physics = Granular<>;
  using diagnostics = WallForces;
};
using S = Solver<Sand>;

int main(int argc, char** argv) {
  using namespace scree::fields;
  Kokkos::ScopeGuard const kokkos(argc, argv);
  char const* const file = argc > 1 ? argv[1] : "vessel.stl";
  double const mass_of_sand = argument<double>(argc, argv, 2, 0.2);          // kg
  double const dr = argument<double>(argc, argv, 3, 4) * 1e-3;               // m
  double const duration = argument<double>(argc, argv, 4, 0.3), rho = 1500;  // s, kg/m^3

  Mesh const vessel = read_mesh(file, {.scale = 1e-3});
  fmt::print("{}", vessel.report().text(dr));
  auto const bed = fill_with_mass(vessel, mass_of_sand, rho, dr);
  fmt::print("{} particles up to {:.1f} mm\n", bed.points.size(), 1e3 * bed.level);

  // Walls surround the inside up to a little above the bed; the lid in the drawing is left out.
  HalfSpace<3> const rim{.point = {0, 0, bed.level + 4 * dr}, .normal = {0, 0, 1}};
  Groups<3> walls;
  walls.add("vessel", points_within(wall_around(vessel, dr, 3), rim));

  double const c = 12 * std::sqrt(9.81 * bed.level);
  MuOfI<> const law{.elastic = {.young = 0.74 * rho * c * c, .poisson = 0.3, .rest_density = rho},
                    .grains = {.diameter = 0.5e-3}};
  S solver({.spacing = dr, .physics = {.law = law}}, bed.points, walls);
  solver.set(volume, bed.volumes, [](double v) { return v; });
  Geostatic const at_rest{.surface_height = bed.level, .density = rho, .gravity = 9.81, .K0 = 0.6};
  solver.set(stress, [&](auto const& x) { return packed<3>(Mat<3, double>(at_rest(x))); });

  BodySeries output("particles.vtkhdf", Fields<Velocity, Stress>{}, Bodies<Material, Wall>{}, {.overwrite = true});
  CsvSeries table("vessel.csv", {{"time", "s"}, {"mass", "kg"}, {"force on the vessel over weight"}, {"speed", "m/s"}});
  Progress progress({.end = duration, .name = "t", .unit = 1});
  run_with(solver, duration,
           {every<S>(duration / 30,
                     [&](S& now) {
                       output.append(now);
                       double carried = 0, speed = 0;
                       for (double const v : now.material().to_host(volume)) carried += rho * v;
                       for (auto const& u : now.material().to_host(velocity)) speed = std::max(speed, norm(u));
                       double const force = -wall_load(now, walls, "vessel").force[2];
                       table.row({now.time(), carried, force / (mass_of_sand * 9.81), speed});
                     })},
           progress);
  progress.finish(solver);
}
