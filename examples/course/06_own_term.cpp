// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// A force of your own: grains that sink in a viscous liquid, which holds each of them back.
//
//   course_06_own_term [duration in s]
//
// The liquid pulls with the acceleration -k u, so that grains sink with the speed (g/k)(1 - exp(-k t)). One sees, in
// ParaView, particles.vtkhdf coloured by velocity: a square of sand sinks steadily, lands and spreads to a heap. In
// speed.csv: its speed next to the exact one, until it lands.
#include <scree/granular/granular.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/probes/region.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

using namespace scree;

// A function of one particle: the fields that it reads and writes, and how. A sum over neighbours is written the same
// way, with (i, j, ij, sum) as arguments: see docs/extending.md.
struct Drag {
  double k = 0;  // 1/s
  using reads = Fields<Velocity, Acceleration>;
  using writes = Fields<Acceleration>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using vector = std::remove_cvref_t<decltype(i[velocity])>;
    out[acceleration] = i[acceleration] - typename vector::Scalar(k) * i[velocity];
  }
};

// Granular mechanics with one more pass in the stage that computes the acceleration, behind the others.
struct SandInLiquid : Granular<MuOfI<>> {
  double drag = 0;  // 1/s

  auto stages(Resolution const& resolution) const {
    auto const [stress_stage, motion_stage] = Granular::stages(resolution);
    auto const with_drag = std::tuple_cat(motion_stage.passes, std::tuple(point_pass<Material>("drag", Drag{drag})));
    return std::tuple(stress_stage, stage<Fields<Velocity, Position>>(with_drag));
  }

  // The step must resolve the decay of the velocity.
  auto limits(Resolution const& resolution) const {
    return std::tuple_cat(Granular::limits(resolution), std::tuple(limit("drag", 0.2 / drag)));
  }
};

struct Sinking : Formulation<2> {
  using physics = SandInLiquid;
};
using S = Solver<Sinking>;

int main(int argc, char** argv) {
  Kokkos::ScopeGuard const kokkos(argc, argv);
  double const duration = argc > 1 ? std::stod(argv[1]) : 1.2;
  double const side = 0.05, height = 0.1, dr = 0.0025, k = 50;  // m, 1/s

  auto const square = fill(Box<2>{{-side / 2, height}, {side / 2, height + side}}, dr);
  auto const floor = fill(Box<2>{{-3 * side, -3 * dr}, {3 * side, 0}}, dr);

  SandInLiquid physics;
  physics.law = {.elastic = {.young = 5e4, .poisson = 0.3, .rest_density = 1500}, .grains = {.diameter = 1e-3}};
  physics.drag = k;
  S solver({.spacing = dr, .physics = physics}, square, floor);

  BodySeries output("particles.vtkhdf", Fields<Velocity, Stress>{}, Bodies<Material, Wall>{}, {.overwrite = true});
  CsvSeries table("speed.csv", {{"time", "s"}, {"speed", "m/s"}, {"exact speed", "m/s"}, {"centre", "m"}});
  solver.run(duration, {every<S>(duration / 60, [&](S& now) {
               output.append(now);
               double const speed = -mean_in(now, velocity, whole_space<2>()).value[1];
               double const centre = mean_in(now, position, whole_space<2>()).value[1];
               table.row({now.time(), speed, 9.81 / k * (1 - std::exp(-k * now.time())), centre});
             })});
}
