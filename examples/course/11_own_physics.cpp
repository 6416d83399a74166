// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Physics of your own: a weakly compressible liquid.
//
//   course_11_own_physics [duration in s] [width of the water over that of the tank]
//
// In ParaView, particles.vtkhdf coloured by fluid_pressure shows a dam break: water runs along the floor and up the
// wall. With a width of 1 the water rests, and tank.csv has the hydrostatic pressure on the floor.
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/probes/points.hpp>
#include <scree/run/argument.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>
#include <scree/terms/artificial_viscosity.hpp>
#include <scree/terms/continuity.hpp>
#include <scree/terms/gravity.hpp>
#include <scree/terms/shepard.hpp>

using namespace scree;

struct FluidPressure : Scalar<"fluid pressure", "Pa"> {};
inline constexpr FluidPressure fluid_pressure{};

struct EquationOfState {  // p = c^2 (rho - rho_0), V = m/rho
  double c, rho0;
  using reads = Fields<Mass, Density>;
  using writes = Fields<Volume, FluidPressure>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace scree::fields;
    out[volume] = i[mass] / i[density];
    out[fluid_pressure] = c * c * (i[density] - rho0);
  }
};
struct PressureForce {  // du_i/dt = -1/rho_i sum_j V_j (p_i + p_j) gradW_ij, symmetric in i and j
  using reads = Fields<Volume, FluidPressure>;
  using reads_i = Fields<Density>;
  using adds = Fields<Acceleration>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace scree::fields;
    sum[acceleration] += (-j[volume] * (i[fluid_pressure] + j[fluid_pressure]) / i[density]) * ij.gradW();
  }
};
struct WallSums {  // sums over the liquid near a wall particle: pressure with hydrostatic difference, and weights
  double rho0;
  Gravity gravity;
  using reads = Fields<Volume, FluidPressure>;
  using adds = Fields<WeightedSum<FluidPressure>, Weight>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    using namespace scree::fields;
    double const w = j[volume] * ij.W(), below = rho0 * dot(gravity.vector<typename IJ::vector>(), ij.x);
    sum[WeightedSum<FluidPressure>{}] += w * (j[fluid_pressure] + below);
    sum[weight] += w;
  }
};
struct WallPressure {  // weighted mean, Adami, Hu & Adams (2012), eq. 27, but never negative: walls do not pull
  using reads = Fields<>;
  using writes = Fields<FluidPressure>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    using namespace scree::fields;
    out[fluid_pressure] = total[weight] > 0 ? Kokkos::max(total[WeightedSum<FluidPressure>{}] / total[weight], 0.0) : 0;
  }
};
struct AddGravity {
  Gravity gravity;
  using reads = Fields<Acceleration>;
  using writes = Fields<Acceleration>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace scree::fields;
    using vector = std::remove_cvref_t<decltype(i[acceleration])>;
    out[acceleration] = i[acceleration] + gravity.vector<vector>();
  }
};

struct Liquid {
  double rho0 = 1000, c = 0, viscosity_speed = 0;  // kg/m^3, m/s, m/s
  Gravity gravity = {};
  using evolves = Fields<Position, Velocity, Density>;

  auto passes(Resolution const&) const {
    ArtificialViscosity<DensityOfParticle> const viscosity{{}, viscosity_speed};
    return std::tuple(point_pass<Material>("equation of state", EquationOfState{c, rho0}),
                      pair_pass_then<Wall>("wall pressure", WallPressure{}, over<Material>(WallSums{rho0, gravity})),
                      pair_pass<Material>("rates", over<Material>(Continuity{}, PressureForce{}, viscosity),
                                          over<Wall>(Continuity{}, PressureForce{})),
                      point_pass<Material>("gravity", AddGravity{gravity}));
  }
  auto limits(Resolution const& r) const { return std::tuple(limit("acoustic", 0.2 * r.smoothing_length / c)); }
};

struct Water : Formulation<2> {
  using physics = Liquid;
};
using S = Solver<Water>;

int main(int argc, char** argv) {
  using namespace scree::fields;
  Kokkos::ScopeGuard const kokkos(argc, argv);
  double const duration = argument<double>(argc, argv, 1, 1), share = argument<double>(argc, argv, 2, 0.25);
  double const depth = 0.2, tank = 0.5, dr = 0.01, rho0 = 1000, c = 20 * std::sqrt(9.81 * depth);  // m, kg/m^3, m/s

  auto const water = fill_lattice(Box<2>{{0, 0}, {share * tank, depth}}, dr);
  auto const walls = fill_between(Box<2>{{0, 0}, {tank, 9}}, Box<2>{{-3 * dr, -3 * dr}, {tank + 3 * dr, 0.5}}, dr);
  S solver({.spacing = dr, .physics = {.rho0 = rho0, .c = c, .viscosity_speed = 0.05 * c}}, water, walls);
  auto const hydrostatic = [&](auto const& x) { return rho0 + rho0 * 9.81 * (depth - x[1]) / (c * c); };
  solver.set(density, hydrostatic);
  solver.set(mass, [&](auto const& x) { return hydrostatic(x) * dr * dr; });

  BodySeries output("particles.vtkhdf", Fields<Velocity, FluidPressure>{}, Bodies<Material>{}, {.overwrite = true});
  CsvSeries table("tank.csv", {{"time", "s"}, {"front", "m"}, {"pressure on the floor", "Pa"}, {"rho g depth", "Pa"}});
  solver.run(duration, {every<S>(duration / 50, [&](S& now) {
               now.update_rates();  // computes the pressure at this time, not that of the last step
               output.append(now);
               double front = 0, floor = 0;
               for (auto const& x : now.material().to_host(position)) front = std::max(front, x[0] + dr / 2);
               for (auto const& p : mean_at(now, fluid_pressure, points_along<2>({0.1, 0.05}, {0.4, 0.05}, 16)))
                 floor += p.weight > 0 ? (p.value + rho0 * 9.81 * 0.05) / 16 : 0;
               table.row({now.time(), front, floor, rho0 * 9.81 * depth});
             })});
}
