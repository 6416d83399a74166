// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "formulations.hpp"

#include <scree/rigid/measured_mass.hpp>
#include <scree/setup/setup.hpp>

#include <cmath>
#include <vector>

// Rigid bodies without grains.
namespace scree::test {

struct Block : RigidBody {
  static constexpr std::string_view name = "block";
};
/// No forces but gravity.
struct Weight {
  using evolves = Fields<Velocity, Position>;
  Gravity gravity = {};
  auto stages(Resolution const&) const { return std::tuple(stage<evolves>(std::tuple<>())); }
  std::tuple<> limits(Resolution const&) const { return {}; }
  template <BodyTag Body>
  std::tuple<> reaction_passes(Resolution const&) const {
    return {};
  }
};
template <class Q, class Integrator = Midpoint, class Motion = AtRest>
struct Free : Formulated<Q, Weight, Motion> {
  using bodies = Bodies<Material, Wall, Block>;
  using integrator = Integrator;
};

/// A solver of rigid bodies, one for each set of points, and walls. Bodies may have more inertia than their particles.
template <class F>
Solver<F> solver_of_bodies(double spacing, RigidBodies<F::dim> const& rigid, Gravity const& gravity,
                           std::vector<Points<F::dim>> const& bodies, Points<F::dim> const& walls = {}) {
  Groups<F::dim> blocks;
  for (std::size_t k = 0; k < bodies.size(); ++k) blocks.add("block " + std::to_string(k), bodies[k]);
  using X = Vec<F::dim, typename F::real>;
  return Solver<F>({.spacing = spacing, .physics = {.gravity = gravity}, .rigid = rigid, .start_checks = false},
                   particles_of<Material>(std::vector<X>()), particles_of<Wall>(cast<typename F::real>(walls)),
                   particles_of<Block>(blocks));
}

/// A floor of three rows below zero, `half` wide to each side.
template <int Dim>
Points<Dim> floor_of(double half, double spacing) {
  Vec<Dim, double> low = Vec<Dim, double>::Constant(-half), high = Vec<Dim, double>::Constant(half);
  low[Dim - 1] = -3 * spacing, high[Dim - 1] = 0;
  return fill_lattice(Box<Dim>{low, high}, spacing);
}

template <class S>
auto state_of(S const& solver, std::size_t body = 0) {
  using namespace fields;
  auto const& states = solver.template body<RigidStates>();
  struct State {
    Vec<S::policy::dim, double> x, u, force;
    Attitude<S::policy::dim> q;
    Turn<S::policy::dim> w, L;
  };
  return State{states.to_host(rigid_centre)[body],        states.to_host(rigid_velocity)[body],
               states.to_host(rigid_contact_force)[body], states.to_host(rigid_attitude)[body],
               states.to_host(angular_velocity)[body],    states.to_host(angular_momentum)[body]};
}
template <class S>
void advance_to(S& solver, double time) {
  while (solver.time() < time * (1 - 1e-14)) solver.step(time - solver.time());
}

}  // namespace scree::test
