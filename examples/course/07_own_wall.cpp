// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// A wall of your own: a conveyor belt. Its particles stay where they are; grains see its surface move.
//
//   course_07_own_wall [duration in s]
//
// A layer at rest slides on the belt until friction has brought it to the speed of the belt: its mean velocity grows by
// k g per second, k the friction coefficient. One sees, in ParaView, particles.vtkhdf coloured by velocity: shear stays
// next to the belt. In belt.csv: the mean velocity next to min(k g t, speed of the belt).
#include <scree/granular/granular.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/laws/drucker_prager.hpp>
#include <scree/probes/region.hpp>
#include <scree/run/argument.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

using namespace scree;

// A lens: how a particle i of the material sees a wall particle j. It provides fields of j for the terms, from fields
// of i (`reads_i`) and of j (`reads`). Rho gives the density.
template <class Rho>
struct BeltLens {
  double speed;  // m/s
  Rho rho;
  Gravity gravity;
  bool operator==(BeltLens const&) const = default;
  using provides = Fields<Velocity, Stress>;
  using reads = Fields<Position>;
  using reads_i = Merge<Fields<Position, Volume, Velocity, Stress>, typename Rho::reads>;

  // Half way between i and j the velocity is that of the belt.
  template <class I, class J>
  SCREE_FN auto operator()(Velocity, I const& i, J const&) const {
    using namespace scree::fields;
    using vector = std::remove_cvref_t<decltype(i[velocity])>;
    vector seen = -i[velocity];
    seen[0] += 2 * typename vector::Scalar(speed);
    return seen;
  }
  // The stress of i, continued under its own weight.
  template <class I, class J>
  SCREE_FN auto operator()(Stress, I const& i, J const& j) const {
    using namespace scree::fields;
    using vector = std::remove_cvref_t<decltype(i[position])>;
    using packed_stress = std::remove_cvref_t<decltype(i[stress])>;
    vector const pull = typename vector::Scalar(rho.of(i)) * gravity.vector<vector>();
    return walls::continued<packed_stress, vector>(i[stress], pull, j[position] - i[position]);
  }
};

// A scheme for walls: passes that compute fields of the wall particles (here none), and the lens.
struct Belt {
  double speed = 0;  // m/s
  std::tuple<> velocity_passes() const { return {}; }
  template <class Rho>
  std::tuple<> stress_passes(Rho const&, Gravity const&) const {
    return {};
  }
  template <class Rho>
  BeltLens<Rho> lens(Rho const& rho, Gravity const& gravity) const {
    return {speed, rho, gravity};
  }
};

struct SandOnBelt : GranularModels {  // the models of Granular: those that are not named have a default
  using law = DruckerPrager;
  using walls = Belt;
};
struct Conveyor : Formulation<2> {
  using physics = Granular<SandOnBelt>;
};
using S = Solver<Conveyor>;

int main(int argc, char** argv) {
  using namespace scree::fields;
  Kokkos::ScopeGuard const kokkos(argc, argv);
  double const duration = argument<double>(argc, argv, 1, 0.5);
  double const length = 0.1, depth = 0.04, dr = 0.0025, rho = 1500, k = 0.3, speed = 0.5;  // m, kg/m^3, -, m/s

  auto const layer = fill_lattice(Box<2>{{0, 0}, {length, depth}}, dr);
  auto const belt = fill_lattice(Box<2>{{0, -3 * dr}, {length, 0}}, dr);
  DruckerPrager const sand{.elastic = {.young = 5e4, .poisson = 0.3, .rest_density = rho}, .cone = {.friction = k}};
  S solver(
      {.spacing = dr, .physics = {.law = sand, .walls = {speed}}, .periods = {{.axis = 0, .low = 0, .high = length}}},
      layer, belt);
  Geostatic const at_rest{.surface_height = depth, .density = rho, .gravity = 9.81};
  solver.set(stress, [&](auto const& x) { return packed<2>(Mat<3, double>(at_rest(x))); });

  BodySeries output("particles.vtkhdf", Fields<Velocity, Stress>{}, Bodies<Material, Wall>{}, {.overwrite = true});
  CsvSeries table("belt.csv", {{"time", "s"}, {"mean velocity", "m/s"}, {"velocity by friction", "m/s"}});
  solver.run(duration, {every<S>(duration / 50, [&](S& now) {
               output.append(now);
               table.row({now.time(), mean_in(now, velocity, whole_space<2>()).value[0],
                          std::min(k * 9.81 * now.time(), speed)});
             })});
}
