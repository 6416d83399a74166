// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Contact of rigid bodies with walls and with each other: two stones slide along a floor into a bed of sand.
//
//   course_15_stone [speed in m/s] [duration in s]
//
// In ParaView, particles.vtkhdf coloured by velocity shows how the sliding stones slow down, the second runs into the
// first, and the sand stops both. The tables stones/first.csv and stones/second.csv have position, velocity and
// attitude over time, and the forces of grains and of contacts. Until a stone reaches the sand, its speed falls at the
// rate of the coefficient of friction times g.
#include <scree/granular/granular.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/rigid_series.hpp>
#include <scree/rigid/measured_mass.hpp>
#include <scree/run/argument.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

using namespace scree;

struct Stone : RigidBody {
  static constexpr std::string_view name = "stone";
};
struct Trap : Formulation<2> {
  using physics = Granular<>;
  using bodies = Bodies<Material, Wall, Stone>;
  using integrator = SymplecticEuler;
};
using S = Solver<Trap>;

int main(int argc, char** argv) {
  Kokkos::ScopeGuard const kokkos(argc, argv);
  double const speed = argument<double>(argc, argv, 1, 2.5);
  double const duration = argument<double>(argc, argv, 2, 0.8);
  double const dr = 0.01, depth = 0.04, rho = 1500;  // m, m, kg/m^3

  Box<2> const room{{0, 0}, {1.4, 0.3}}, bed{{0.7, 0}, {1.4, depth}};
  Groups<2> stones;
  RigidBodies<2> rigid{.contact = {.restitution = 0.4, .friction = 0.3}};  // default stiffness: that of the sand
  auto const add = [&](char const* name, Box<2> const& block, double start) {
    stones.add(name, fill_lattice(block, dr));
    rigid.bodies.push_back({.properties = mass_properties(block, 2500, dr), .velocity = {start, 0}});
  };
  add("first", {{0.3, 0}, {0.4, 0.06}}, speed);
  add("second", {{0.1, 0}, {0.2, 0.06}}, 1.6 * speed);

  MuOfI<> const sand{.elastic = {.young = 1e6, .poisson = 0.3, .rest_density = rho}, .grains = {.diameter = 2e-3}};
  S solver({.spacing = dr, .physics = {.law = sand}, .rigid = rigid}, particles_of<Material>(fill_lattice(bed, dr)),
           particles_of<Wall>(wall_around(room, dr, 3)), particles_of<Stone>(stones));
  Geostatic const at_rest{depth, rho, 9.81, 0.6};
  solver.set(fields::stress, [&](auto const& x) { return packed<2>(Mat<3, double>(at_rest(x))); });

  BodySeries output("particles.vtkhdf", Fields<Velocity, Stress>{}, Bodies<Material, Stone>{}, {.overwrite = true});
  RigidSeries states("stones", stones);
  solver.run(duration, {every<S>(duration / 40, [&](S& now) { output.append(now); }),
                        every<S>(duration / 200, [&](S& now) { states.append(now); })});
}
