// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Three dimensions: a cylinder of sand is released and spreads into a heap.
//
//   course_09_three_dimensions [particles across the radius] [duration in units of sqrt(H/g)]
//
// Changes from two dimensions: Formulation<3> is used, vectors have three components, and z points upwards. In
// ParaView, particles.vtkhdf (Point Gaussian, coloured by velocity) shows a cone that stays round. The table heap.csv
// has the run-out. For a height of one radius, the run-out in experiments is 1 to 1.5 radii (Lube et al. 2004).
#include <scree/granular/granular.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/probes/region.hpp>
#include <scree/run/argument.hpp>
#include <scree/run/progress.hpp>
#include <scree/run/run_with.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

#include <numbers>

using namespace scree;

struct Sand : Formulation<3> {
  using physics = Granular<>;
};
using S = Solver<Sand>;

int main(int argc, char** argv) {
  using namespace scree::fields;
  Kokkos::ScopeGuard const kokkos(argc, argv);
  int const across = argument<int>(argc, argv, 1, 10);
  double const duration = argument<double>(argc, argv, 2, 5);
  double const radius = 0.03, height = radius, dr = radius / across, rho = 1500;  // m, kg/m^3
  double const fall_time = std::sqrt(height / 9.81), c = 12 * std::sqrt(9.81 * height);

  // A cylinder of sand cut out of a lattice. The floor is a disc three layers thick.
  Vec<3, double> const corner(-4 * radius, -4 * radius, -3 * dr);
  auto const sand =
      fill_lattice(Cylinder{.axis = 2, .centre = {0, 0, 0}, .radius = radius, .from = 0, .to = height}, dr, corner);
  auto const floor = fill_lattice(
      Cylinder{.axis = 2, .centre = {0, 0, 0}, .radius = 4 * radius, .from = -3 * dr, .to = 0}, dr, corner);

  MuOfI<> const law{.elastic = {.young = 0.74 * rho * c * c, .poisson = 0.3, .rest_density = rho},
                    .grains = {.diameter = 0.5e-3},
                    .mu_s = 0.42,
                    .mu_d = 1.1};
  S solver({.spacing = dr, .physics = {.law = law}}, sand, floor);
  Geostatic const at_rest{.surface_height = height, .density = rho, .gravity = 9.81};
  solver.set(stress, [&](auto const& x) { return packed<3>(Mat<3, double>(at_rest(x))); });

  BodySeries output("particles.vtkhdf", Fields<Velocity, Stress, ShearRate>{}, Bodies<Material>{}, {.overwrite = true});
  CsvSeries table("heap.csv", {{"time", "sqrt(H/g)"},
                               {"run-out", "radii"},
                               {"off the axis", "radii"},
                               {"height of the centre", "radii"},
                               {"speed", "m/s"}});
  Progress progress({.end = duration, .name = "t/sqrt(H/g)", .unit = fall_time});
  run_with(solver, duration * fall_time,
           {every<S>(0.1 * fall_time,
                     [&](S& now) {
                       output.append(now);
                       // Depth in rings two spacings wide. The rim is the outermost ring with a depth of 0.05 heights
                       // or more.
                       std::vector<double> depth(static_cast<std::size_t>(2 * across));
                       for (auto const& x : now.material().to_host(position)) {
                         auto const ring = std::size_t(std::hypot(x[0], x[1]) / (2 * dr));
                         depth.at(ring) += dr / (std::numbers::pi * 4 * double(2 * ring + 1));
                       }
                       std::size_t rim = depth.size();
                       while (rim > 0 && depth[rim - 1] < 0.05 * height) --rim;
                       auto const centre = mean_in(now, position, whole_space<3>()).value;
                       double speed = 0;
                       for (auto const& u : now.material().to_host(velocity)) speed = std::max(speed, norm(u));
                       table.row({now.time() / fall_time, double(2 * rim) * dr / radius - 1,
                                  std::hypot(centre[0], centre[1]) / radius, centre[2] / radius, speed});
                     })},
           progress);
  progress.finish(solver);
}
