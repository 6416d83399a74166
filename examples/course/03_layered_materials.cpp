// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Three materials in one run: a slope of sand on a weak layer, under a heavy fill.
//
//   course_03_layered_materials [friction of the weak layer] [duration in s]
//
// In ParaView, colour particles.vtkhdf by group: with a friction of 0.1 the fill and the sand slide out on the weak
// layer; with 0.6 only the face of the slope slumps. The table layers.csv has the mass of each group, which is constant
// to the last digit, and the displacement of the centre of each group.
#include <scree/granular/granular.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/laws/by_group.hpp>
#include <scree/run/argument.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/slip.hpp>
#include <scree/solver/solver.hpp>

#include <array>

using namespace scree;

struct Layers : GranularModels {  // models of Granular; any that is not named has a default
  using law = ByGroup<MuOfI<>>;   // one set of parameters for each group of particles
};
struct Slope : Formulation<2> {
  using physics = Granular<Layers>;
  using integrator = SymplecticEuler;  // a sixth of the default's run time, at three times its step
};
using S = Solver<Slope>;

/// Returns grains in which elastic waves travel at 12 sqrt(g height), equally fast in all layers.
MuOfI<> grains(double density, double friction, double height) {
  double const c = 12 * std::sqrt(9.81 * height);
  return {.elastic = {.young = 0.74 * density * c * c, .poisson = 0.3, .rest_density = density},
          .grains = {.diameter = 1e-3},
          .mu_s = friction,
          .mu_d = friction + 0.3};
}

int main(int argc, char** argv) {
  using namespace scree::fields;
  Kokkos::ScopeGuard const kokkos(argc, argv);
  double const weak_friction = argument<double>(argc, argv, 1, 0.1);
  double const duration = argument<double>(argc, argv, 2, 0.5);
  double const width = 0.2, height = 0.12, dr = 0.004;  // m

  Groups<2> soil, walls;
  soil.add("weak layer", fill_lattice(Box<2>{{0, 0}, {width, height / 6}}, dr));
  soil.add("sand", fill_lattice(Box<2>{{0, height / 6}, {width, 2 * height / 3}}, dr));
  soil.add("fill", fill_lattice(Box<2>{{0, 2 * height / 3}, {width, height}}, dr));
  walls.add("floor", fill_lattice(Box<2>{{-3 * dr, -3 * dr}, {3 * width, 0}}, dr));
  walls.add("side", fill_lattice(Box<2>{{-3 * dr, 0}, {0, height + 6 * dr}}, dr));

  ByGroup<MuOfI<>> law(soil);
  law.set(soil.number("weak layer"), grains(1400, weak_friction, height));
  law.set(soil.number("sand"), grains(1600, 0.6, height));
  law.set(soil.number("fill"), grains(2200, 0.6, height));
  S solver({.spacing = dr, .physics = {.law = law, .cfl = 0.6}}, soil, walls);
  set_slip(solver, walls, "side", Vec<2, double>(1, 0));
  solver.set(stress, [&](auto const& x) {
    double const depth = height - x[1], heavy = std::min(depth, height / 3),
                 p = 9.81 * (2200 * heavy + 1600 * (depth - heavy));
    return Vec<4, double>(-p / 2, -p, -p / 2, 0);
  });

  BodySeries output("particles.vtkhdf", Fields<Velocity, Stress, Density, Group>{}, Bodies<Material>{},
                    {.overwrite = true});
  CsvSeries table("layers.csv", {{"time", "s"},
                                 {"mass of the weak layer", "kg/m"},
                                 {"mass of the sand", "kg/m"},
                                 {"mass of the fill", "kg/m"},
                                 {"way of the weak layer", "m"},
                                 {"way of the sand", "m"},
                                 {"way of the fill", "m"}});
  solver.run(
      duration, {every<S>(duration / 50, [&](S& now) {
        output.append(now);
        auto const x = now.material().to_host(position);
        auto const V = now.material().to_host(volume), rho = now.material().to_host(density);
        auto const number = now.material().to_host(group);
        std::array<double, 3> total = {}, way = {};
        for (std::size_t i = 0; i < x.size(); ++i) {
          auto const k = std::size_t(number[i]);
          total[k] += rho[i] * V[i], way[k] += rho[i] * V[i] * (x[i][0] - width / 2);
        }
        table.row({now.time(), total[0], total[1], total[2], way[0] / total[0], way[1] / total[1], way[2] / total[2]});
      })});
}
