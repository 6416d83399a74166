// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// A law of your own: clay with a frictionless strength (Tresca, von Mises) in a vertical cut.
//
//   course_05_own_law [strength over that of the critical cut] [duration in s]
//
// A vertical cut in clay of undrained shear strength c_u stands up to the height 3.83 c_u/(rho g). In ParaView, colour
// particles.vtkhdf by mobilised_strength: with a strength of 0.5 a block slides down on a curved surface; with 2 the
// cut stands. The table cut.csv has the advance of the front.
#include <scree/granular/granular.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/run/argument.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/slip.hpp>
#include <scree/solver/solver.hpp>

using namespace scree;

// The law is elastic up to sqrt(J2) = strength at any pressure. The base class Elastic provides the stress rate,
// density, sound speed and moduli. The addition is the return to the yield surface along the deviator, because plastic
// flow preserves volume.
struct Clay : Elastic {
  double strength = 0;  // c_u, Pa

  template <class Real, class Point>
  SCREE_FN Real shear_strength(Real, Point const&) const {
    return Real(strength);
  }
  template <class Real, class Point, class History>
  SCREE_FN StressTensor<Real> admissible(StressTensor<Real> const& trial, Point const&, History&&) const {
    StressTensor<Real> const s = deviator_of(trial);
    Real const tau = equivalent_shear_stress(s);
    if (!(tau > Real(strength))) return trial;
    return trial - (1 - Real(strength) / tau) * s;
  }
};
static_assert(ConstitutiveLaw<Clay>);

struct OfClay : GranularModels {  // models of Granular; any that is not named has a default
  using law = Clay;
  using filter = NoFilter;
};
struct Cut : Formulation<2> {
  using physics = Granular<OfClay>;
};
using S = Solver<Cut>;

struct MobilisedStrength : Scalar<"mobilised strength", "Pa"> {
  using reads = Fields<Stress>;
  template <class I>
  static double of(I const& i, Resolution const&) {
    return equivalent_shear_stress(deviator_of(unpacked(i[fields::stress])));
  }
};

int main(int argc, char** argv) {
  using namespace scree::fields;
  Kokkos::ScopeGuard const kokkos(argc, argv);
  double const ratio = argument<double>(argc, argv, 1, 0.5);
  double const duration = argument<double>(argc, argv, 2, 1);
  double const height = 1, width = 2, dr = 0.05, rho = 1800;  // m, kg/m^3
  double const strength = ratio * rho * 9.81 * height / 3.83;

  // Clay on a rough floor, with a smooth wall on its left and a free face on its right.
  auto const clay = fill_lattice(Box<2>{{0, 0}, {width, height}}, dr);
  Groups<2> walls;
  walls.add("floor", fill_lattice(Box<2>{{-3 * dr, -3 * dr}, {3 * width, 0}}, dr));
  walls.add("side", fill_lattice(Box<2>{{-3 * dr, 0}, {0, 1.2 * height}}, dr));
  Clay const law{{.young = 1e6, .poisson = 0.4, .rest_density = rho}, strength};
  S solver({.spacing = dr, .physics = {.law = law}}, clay, walls);
  set_slip(solver, walls, "side", Vec<2, double>(1, 0));
  Geostatic const at_rest{.surface_height = height, .density = rho, .gravity = 9.81};
  solver.set(stress, [&](auto const& x) { return packed<2>(Mat<3, double>(at_rest(x))); });

  BodySeries output("particles.vtkhdf", Fields<Velocity, Stress, MobilisedStrength>{}, Bodies<Material>{},
                    {.overwrite = true});
  CsvSeries table("cut.csv", {{"time", "s"}, {"advance of the front", "m"}, {"largest stress over strength"}});
  solver.run(duration, {every<S>(duration / 40, [&](S& now) {
               output.append(now);
               double front = 0, largest = 0;
               for (auto const& x : now.material().to_host(position)) front = std::max(front, x[0] + dr / 2);
               for (auto const& sigma : now.material().to_host(stress))
                 largest = std::max(largest, equivalent_shear_stress(deviator_of(unpacked(sigma))));
               table.row({now.time(), front - width, largest / strength});
             })});
}
