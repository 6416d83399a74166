// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "granular.hpp"

#include <scree/granular/wall_forces.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/setup/setup.hpp>

#include <vector>

// A small drum, less than half full, as in examples/drum: the balances of its bed.
namespace scree::test::drum {

inline double const radius = 0.035, level = -0.0056, rate = 0.5236;  // m, m, rad/s: 5 turns a minute

/// A formulation whose walls carry the force of the material.
template <class Physics, class Motion, class Integrator = SymplecticEuler>
struct Walled : Formulation<2> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Physics;
  using motion = Motion;
  using integrator = Integrator;
  using diagnostics = WallForces;
};

struct Numbers {
  double spacing = 2.5e-3;       ///< m
  double sound_speed = 5;        ///< m/s
  double viscosity_speed = 0.5;  ///< m/s
};

/// The mechanics of the bed.
template <class Mechanics>
Mechanics mechanics(Numbers const& numbers) {
  Mechanics physics;
  physics.law = {beads(numbers.sound_speed)};
  physics.viscosity_speed = numbers.viscosity_speed;
  physics.cfl = 0.4;
  physics.volume_control.per_strain = 3;
  return physics;
}

/// The wall, one group.
inline Groups<2> wall_of(Numbers const& numbers) {
  Groups<2> wall;
  wall.add("drum", wall_rings(Ball<2>{.centre = {0, 0}, .radius = radius}, numbers.spacing, 3));
  return wall;
}

/// The bed turns with the drum, under a level surface and its own weight; `flowing`: speed at which it slides down at
/// its surface (m/s).
template <class Physics>
Solver<Walled<Physics, Rotation>> turning(Physics const& physics, Numbers const& numbers, double flowing = 0) {
  using namespace fields;
  using X = Vec<2, double>;
  Ball<2> const inside{.centre = {0, 0}, .radius = radius};
  auto const bed = fill_rings(inside, numbers.spacing, HalfSpace<2>{.point = X(0, level), .normal = X(0, 1)});
  Rotation const motion{.rate = -rate};
  Solver<Walled<Physics, Rotation>> solver({.spacing = numbers.spacing, .physics = physics, .motion = motion},
                                           bed.points, wall_of(numbers));
  Geostatic const weight{.surface_height = level, .density = bed_density, .gravity = g, .K0 = 1};
  solver.set(volume, bed.volumes, [](double V) { return V; });
  solver.set(stress, [&](X const& x) { return packed_stress(weight, x); });
  solver.set(velocity, [&](X const& x) {
    return X(motion.velocity(x, 0) + flowing * std::exp((x[1] - level) / 5e-3) * X::UnitX());
  });
  return solver;
}

}  // namespace scree::test::drum
