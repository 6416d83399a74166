// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Single precision, optionally on a GPU: sand in a rotating drum.
//
//   course_10_float_on_gpu [particles across the radius] [turns]
//
// Changes from double precision: Formulation<2, float> is used, and cast<float>() converts the particles. With a Kokkos
// built for CUDA (cmake --preset cuda) the same source runs on the GPU. In ParaView, particles.vtkhdf coloured by
// velocity shows a thin layer that flows down the surface. In slope.csv the slope grows until the sand flows, and then
// stays above the angle of friction.
#include <scree/granular/granular.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/probes/region.hpp>
#include <scree/run/argument.hpp>
#include <scree/run/wall_clock.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

#include <cstdio>
#include <numbers>

using namespace scree;

struct Drum : Formulation<2, float> {
  using physics = Granular<>;
  using motion = Rotation;  // of the walls
};
using S = Solver<Drum>;

int main(int argc, char** argv) {
  using namespace scree::fields;
  using std::numbers::pi;
  Kokkos::ScopeGuard const kokkos(argc, argv);
  int const across = argument<int>(argc, argv, 1, 20);
  double const turns = argument<double>(argc, argv, 2, 0.5);
  double const radius = 0.05, dr = radius / across, rpm = 10, rho = 1500, mu = 0.382;  // m, 1/min, kg/m^3, -

  // The lower half of a disc, and rings of wall particles around the disc. The setup is done in double precision.
  Ball<2> const disc{.centre = {0, 0}, .radius = radius};
  auto const sand = points_within(fill_lattice(disc, dr), Box<2>{{-radius, -radius}, {radius, 0}});
  auto const drum = wall_rings(disc, dr, 3);

  MuOfI<> const law{
      .elastic = {.young = 5e4, .poisson = 0.3, .rest_density = rho}, .grains = {.diameter = 1e-3}, .mu_s = mu};
  S solver({.spacing = dr,
            .physics = {.law = law},
            .motion = {.rate = 2 * pi * rpm / 60},
            .sort_period = 20'000},  // particles are sorted in memory every 20 000 steps
           cast<float>(sand), cast<float>(drum));
  Geostatic const at_rest{.surface_height = 0, .density = rho, .gravity = 9.81};
  solver.set(stress, [&](auto const& x) { return packed<2>(Mat<3, float>(at_rest(x).template cast<float>())); });

  BodySeries output("particles.vtkhdf", Fields<Velocity, Stress, Identity>{}, Bodies<Material, Wall>{},
                    {.overwrite = true});
  CsvSeries table("slope.csv", {{"turns"}, {"slope", "degrees"}, {"angle of friction", "degrees"}});
  double const turn = 60 / rpm, begin = wall_seconds();
  solver.run(turns * turn, {every<S>(turn / 100, [&](S& now) {
               output.append(now);
               // The centre of mass of a half disc is on the normal through the middle of its surface.
               auto const centre = mean_in(now, position, whole_space<2>()).value;
               table.row({now.time() / turn, std::atan2(centre[0], -centre[1]) * 180 / pi,
                          std::asin(friction_ratio(mu)) * 180 / pi});
             })});
  double const seconds = wall_seconds() - begin, particles = double(sand.size());
  std::printf("%s: %.0f particles, %ld steps in %.1f s, %.3g particle-steps/s\n", Drum::space::name(), particles,
              solver.steps(), seconds, double(solver.steps()) * particles / seconds);
}
