// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// A force of your own: grains sink in a viscous liquid, which exerts drag on each of them.
//
//   course_06_own_term [duration in s]
//
// The drag of the liquid adds the acceleration -k u, so grains sink at the speed (g/k)(1 - exp(-k t)). In ParaView,
// particles.vtkhdf coloured by velocity shows a square of sand that sinks steadily, lands and spreads into a heap. The
// table speed.csv has the speed of the sand and the exact speed, which holds until the sand lands.
#include <scree/granular/granular.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/probes/region.hpp>
#include <scree/run/argument.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

using namespace scree;

// A force: the acceleration of a particle as a function of its fields, which are listed in `reads`. Forces can also be
// sums over neighbours, see docs/extending.md.
struct Drag {
  double k = 0;  // 1/s
  using reads = Fields<Velocity>;
  void check() const { check_setting(k >= 0, "k of Drag (1/s)", k, "0 or more"); }
  template <class I>
  SCREE_FN auto acceleration(I const& i) const {
    using namespace scree::fields;
    using vector = std::remove_cvref_t<decltype(i[velocity])>;
    return vector(-typename vector::Scalar(k) * i[velocity]);
  }
};

struct SandInLiquid : GranularModels {  // models of Granular; any that is not named has a default
  using forces = std::tuple<Drag>;
};
struct Sinking : Formulation<2> {
  using physics = Granular<SandInLiquid>;
};
using S = Solver<Sinking>;

int main(int argc, char** argv) {
  using namespace scree::fields;
  Kokkos::ScopeGuard const kokkos(argc, argv);
  double const duration = argument<double>(argc, argv, 1, 1.2);
  double const side = 0.05, height = 0.1, dr = 0.0025, k = 50;  // m, 1/s

  auto const square = fill_lattice(Box<2>{{-side / 2, height}, {side / 2, height + side}}, dr);
  auto const floor = fill_lattice(Box<2>{{-3 * side, -3 * dr}, {3 * side, 0}}, dr);

  MuOfI<> const sand{.elastic = {.young = 5e4, .poisson = 0.3, .rest_density = 1500}, .grains = {.diameter = 1e-3}};
  S solver({.spacing = dr, .physics = {.law = sand, .forces = {Drag{k}}}}, square, floor);

  BodySeries output("particles.vtkhdf", Fields<Velocity, Stress>{}, Bodies<Material, Wall>{}, {.overwrite = true});
  CsvSeries table("speed.csv", {{"time", "s"}, {"speed", "m/s"}, {"exact speed", "m/s"}, {"centre", "m"}});
  solver.run(duration, {every<S>(duration / 60, [&](S& now) {
               output.append(now);
               double const speed = -mean_in(now, velocity, whole_space<2>()).value[1];
               double const centre = mean_in(now, position, whole_space<2>()).value[1];
               table.row({now.time(), speed, 9.81 / k * (1 - std::exp(-k * now.time())), centre});
             })});
}
