// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// A rigid body carried and pushed by grains: a wheel with a given angular speed sinks into a bed and travels.
//
//   course_14_wheel [angular speed in rad/s] [duration in s]
//
// In ParaView, particles.vtkhdf coloured by velocity shows how the wheel settles, rolls to the right and leaves a rut.
// The table wheel.csv has the travel and the sinkage of the axle, the vertical force of the grains over the weight of
// the wheel (on average 1), and the moment that drives the wheel.
#include <scree/granular/granular.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/rigid/measured_mass.hpp>
#include <scree/run/argument.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

using namespace scree;

struct Wheel : RigidBody {  // each group of its particles is one rigid body
  static constexpr std::string_view name = "wheel";
};
struct Track : Formulation<2> {
  using physics = Granular<>;
  using bodies = Bodies<Material, Wall, Wheel>;
  using integrator = SymplecticEuler;
};
using S = Solver<Track>;

int main(int argc, char** argv) {
  using namespace scree::fields;
  Kokkos::ScopeGuard const kokkos(argc, argv);
  double const speed = argument<double>(argc, argv, 1, 3);
  double const duration = argument<double>(argc, argv, 2, 1.5);
  double const length = 0.6, depth = 0.08, radius = 0.06, dr = 0.006, rho = 1500;  // m, kg/m^3

  Box<2> const bed{{0, 0}, {length, depth}}, room{{0, 0}, {length, 0.3}};
  Ball<2> const disc{.centre = {0.12, depth + radius}, .radius = radius};
  Groups<2> wheels;
  wheels.add("wheel", fill_lattice(disc, dr));
  Rigid<2> wheel;
  wheel.properties = mass_properties(disc, 1000, dr);  // kg/m^3
  wheel.given_turning = {-speed};                      // clockwise; the axle is free to sink and travel

  MuOfI<> const sand{.elastic = {.young = 1e6, .poisson = 0.3, .rest_density = rho}, .grains = {.diameter = 0.5e-3}};
  S solver({.spacing = dr, .physics = {.law = sand, .cfl = 0.6}, .rigid = {.bodies = {wheel}}},
           particles_of<Material>(fill_lattice(bed, dr)), particles_of<Wall>(wall_around(room, dr, 3)),
           particles_of<Wheel>(wheels));
  Geostatic const at_rest{depth, rho, 9.81, 0.6};
  solver.set(stress, [&](auto const& x) { return packed<2>(Mat<3, double>(at_rest(x))); });

  BodySeries output("particles.vtkhdf", Fields<Velocity, Stress>{}, Bodies<Material, Wheel>{}, {.overwrite = true});
  CsvSeries table("wheel.csv",
                  {{"time", "s"}, {"way", "m"}, {"sinkage", "m"}, {"force over weight", "1"}, {"moment", "N m/m"}});
  double const load = wheel.properties.mass * 9.81;
  solver.run(duration, {every<S>(duration / 60, [&](S& now) {
               output.append(now);
               auto const& state = now.body<RigidStates>();
               Vec<2, double> const way = state.to_host(rigid_centre)[0] - disc.centre;
               table.row({now.time(), way[0], -way[1], state.to_host(rigid_force)[0][1] / load,
                          state.to_host(rigid_moment)[0][0]});
             })});
}
