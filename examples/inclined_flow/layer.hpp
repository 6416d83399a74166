// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "bagnold.hpp"
#include "slope_walls.hpp"

#include <scree/granular/granular.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

// A layer in plane strain that is periodic down the slope, on a rough floor.
namespace inclined_flow {

/// With volume control: without it the layer swells as soon as its rows lose their order, see the README.
struct Models : scree::GranularModels {
  using law = scree::VolumeMemory<scree::MuOfI<>>;
  using volume_control = scree::VolumeConsistency;
  using walls = SlopeWalls;
};
using Physics = scree::Granular<Models>;

struct Formulation : scree::Formulation<2> {
  using physics = Physics;
};

/// Grains with the density of Zhu et al. (2024), Table 1, and the wave speed `sound_speed` (m/s).
inline scree::MuOfI<> beads(double sound_speed, double diameter) {
  double const nu = 0.3, rho = 1500;
  double const young = rho * scree::sq(sound_speed) * (1 + nu) * (1 - 2 * nu) / (1 - nu);
  return {.elastic = {young, nu, rho}, .grains = {diameter}};
}

struct Numbers {
  int rows = 20;                  ///< over the depth
  double viscosity_speed = 0.05;  ///< m/s
  double cfl = 0.4;
  double start = 1;  ///< of the exact velocity
};

/// A layer ten spacings long under the stress of the exact flow.
inline scree::Solver<Formulation> layer(Bagnold const& flow, Numbers const& numbers) {
  double const dr = flow.depth / numbers.rows, length = 10 * dr;
  Physics const physics{.law = {flow.law},
                        .gravity = {flow.gravity, flow.angle},
                        .viscosity_speed = numbers.viscosity_speed,
                        .cfl = numbers.cfl};
  scree::Solver<Formulation> solver({.spacing = dr, .physics = physics, .periods = {{0, 0, length}}},
                                    scree::fill(scree::Box<2>{{0, 0}, {length, flow.depth}}, dr),
                                    scree::fill(scree::Box<2>{{0, -4 * dr}, {length, 0}}, dr));
  solver.set(scree::stress, [&](auto const& x) {
    double const p = flow.pressure(x[1]);
    return scree::Vec<4, double>(-p, -p, -p, flow.shear_stress(x[1]));
  });
  solver.set(scree::velocity,
             [&](auto const& x) { return scree::Vec<2, double>(numbers.start * flow.velocity(x[1]), 0); });
  return solver;
}

}  // namespace inclined_flow
