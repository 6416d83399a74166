// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// A wall of your own: a conveyor belt. The particles of the belt stay in place, but its surface velocity acts on the
// grains.
//
//   course_07_own_wall [duration in s]
//
// A layer that starts at rest slides on the belt until friction has accelerated it to the speed of the belt. The mean
// velocity of the layer grows at the rate k g, where k is the friction coefficient. In ParaView, particles.vtkhdf
// coloured by velocity shows that shear stays close to the belt. The table belt.csv has the mean velocity and, for
// comparison, min(k g t, speed of the belt).
#include <scree/granular/granular.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/laws/drucker_prager.hpp>
#include <scree/probes/region.hpp>
#include <scree/run/argument.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

using namespace scree;

// A lens: the fields of a wall particle j as they enter the sums of a material particle i. The lens provides these
// fields to the terms, computed from fields of i (`reads_i`) and of j (`reads`). Rho gives the density.
template <class Rho>
struct BeltLens {
  double speed;  // m/s
  Rho rho;
  Gravity gravity;
  bool operator==(BeltLens const&) const = default;
  using provides = Fields<Velocity, Stress>;
  using reads = Fields<Position>;
  using reads_i = Merge<Fields<Position, Volume, Velocity, Stress>, typename Rho::reads>;

  // Returns the velocity of j for which the mean of the velocities of i and j is the belt velocity.
  template <class I, class J>
  SCREE_FN auto operator()(Velocity, I const& i, J const&) const {
    using namespace scree::fields;
    using vector = std::remove_cvref_t<decltype(i[velocity])>;
    vector seen = -i[velocity];
    seen[0] += 2 * typename vector::Scalar(speed);
    return seen;
  }
  // Returns the stress of i, extrapolated to j with the weight of the material in between.
  template <class I, class J>
  SCREE_FN auto operator()(Stress, I const& i, J const& j) const {
    using namespace scree::fields;
    using vector = std::remove_cvref_t<decltype(i[position])>;
    using packed_stress = std::remove_cvref_t<decltype(i[stress])>;
    vector const pull = typename vector::Scalar(rho.of(i)) * gravity.vector<vector>();
    return walls::continued<packed_stress, vector>(i[stress], pull, j[position] - i[position]);
  }
};

// A wall scheme: passes that compute fields of the wall particles (none here), and the lens.
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

struct SandOnBelt : GranularModels {  // models of Granular; any that is not named has a default
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
