// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// A column of grains is released and collapses.
//
//   course_02_column_collapse [particles across the column] [duration in units of sqrt(H/g)]
//
// In ParaView, particles.vtkhdf coloured by the magnitude of velocity shows a failure surface, below which grains stay
// at rest, and a front that runs out over the floor. In run_out.csv the front comes to rest. Columns as high as two
// widths ran out by 2.4 to 3.6 widths in channels (Lube et al. 2005, Lajeunesse et al. 2005). The program
// examples/column_collapse compares in detail.
#include <scree/granular/granular.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/run/argument.hpp>
#include <scree/run/progress.hpp>
#include <scree/run/run_with.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/slip.hpp>
#include <scree/solver/solver.hpp>

using namespace scree;

struct Collapse : Formulation<2> {
  using physics = Granular<>;
};
using S = Solver<Collapse>;

int main(int argc, char** argv) {
  using namespace scree::fields;
  Kokkos::ScopeGuard const kokkos(argc, argv);
  int const across = argument<int>(argc, argv, 1, 20);
  double const duration = argument<double>(argc, argv, 2, 5);
  double const width = 0.05, height = 2 * width, dr = width / across;  // m
  double const fall_time = std::sqrt(height / 9.81);                   // s

  // Half of a symmetric column; the plane of symmetry is a smooth wall. The floor and this wall have three rows of
  // particles.
  auto const column = fill_lattice(Box<2>{{0, 0}, {width, height}}, dr);
  Groups<2> walls;
  walls.add("floor", fill_lattice(Box<2>{{-3 * dr, -3 * dr}, {7 * width, 0}}, dr));
  walls.add("plane of symmetry", fill_lattice(Box<2>{{-3 * dr, 0}, {0, height + 6 * dr}}, dr));

  // Elastic waves are about ten times as fast as grains that fall from the top. The material is then stiff enough, and
  // far cheaper to compute than real glass.
  double const c = 12 * std::sqrt(9.81 * height), rho = 1500;
  MuOfI<> const beads{.elastic = {.young = 0.74 * rho * c * c, .poisson = 0.3, .rest_density = rho},
                      .grains = {.diameter = 0.5e-3},
                      .mu_s = 0.42,
                      .mu_d = 1.1};
  S solver({.spacing = dr, .physics = {.law = beads}}, column, walls);
  set_slip(solver, walls, "plane of symmetry", Vec<2, double>(1, 0));
  Geostatic const at_rest{.surface_height = height, .density = rho, .gravity = 9.81};
  solver.set(stress, [&](auto const& x) { return packed<2>(Mat<3, double>(at_rest(x))); });

  BodySeries output("particles.vtkhdf", Fields<Velocity, Stress, ShearRate>{}, Bodies<Material, Wall>{},
                    {.overwrite = true});
  CsvSeries table("run_out.csv",
                  {{"time", "sqrt(H/g)"}, {"run-out", "widths"}, {"summit", "widths"}, {"speed", "m/s"}});
  Progress progress({.end = duration, .name = "t/sqrt(H/g)", .unit = fall_time});
  run_with(solver, duration * fall_time,
           {every<S>(0.1 * fall_time,
                     [&](S& now) {
                       output.append(now);
                       // Depth in slices two spacings wide. The front is the farthest slice with a depth of 0.05
                       // heights or more.
                       std::vector<double> depth(static_cast<std::size_t>(4 * across));
                       for (auto const& x : now.material().to_host(position))
                         depth.at(std::size_t(x[0] / (2 * dr))) += dr / 2;
                       std::size_t front = depth.size();
                       while (front > 0 && depth[front - 1] < 0.05 * height) --front;
                       double speed = 0;
                       for (auto const& u : now.material().to_host(velocity)) speed = std::max(speed, norm(u));
                       table.row({now.time() / fall_time, double(2 * front) * dr / width - 1, depth[0] / width, speed});
                     })},
           progress);
  progress.finish(solver);
}
