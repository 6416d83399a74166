// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "formulations.hpp"

#include <scree/granular/segregating.hpp>
#include <scree/laws/grains.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/segregation/shear_rate_closure.hpp>

#include <cmath>

// A turning box, open above, 16 x 10 particles of two grain sizes: a small version of a drum.
namespace scree::test::granular_box {

struct Models : GranularModels {
  using law = VolumeMemory<MuOfI<BidisperseGrains>>;
  using volume_control = VolumeConsistency;
};
using Mechanics = Granular<Models>;
using Physics = SegregatingGranular<Mechanics, ConservativeSegregation<ShearRateClosure>>;

/// The search is the default one, which keeps its lists over several steps.
template <class Real, class Integrator = Midpoint>
struct Turning : Formulation<2, Real> {
  using integrator = Integrator;
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Physics;
  using motion = Rotation;
};

inline double const spacing = 0.1, width = 1.6, height = 1;  // m

/// A turning box with filter and segregation at every 10th and every 7th step.
template <class Real = double, class Integrator = Midpoint>
Solver<Turning<Real, Integrator>> turning() {
  using namespace fields;
  Physics physics;
  physics.mechanics.law = {{.elastic = {1e5, 0.3, 1500}, .grains = {0.01, 0.02}}};
  physics.mechanics.filter.period = 10;
  physics.transport.closure = {.chi_V = 5, .chi_D = 3, .d_small = 0.01, .d_large = 0.02};
  physics.period = 7;
  Rotation const motion{.rate = 0.5, .centre_x = width / 2, .centre_z = height / 2};
  auto solver = solver_of<Turning<Real, Integrator>>(open_bed<2>({width, height}, spacing), spacing, physics, motion);
  using std::sin;
  solver.set(concentration, [](auto const& x) { return Real(0.5 + 0.4 * sin(5 * x[0] + x[1])); });
  solver.set(velocity, [](auto const& x) { return Vec<2, Real>(Real(0.3) * x[1] * x[1], Real(0)); });
  solver.set(stress, [](auto const& x) {
    Real const p = Real(1500 * 9.81) * (Real(height) - x[1]);
    return Vec<4, Real>(-p / 2, -p, -p * Real(0.6), Real(0));
  });
  return solver;
}

template <class S>
S& stepped(S& solver, long until) {
  while (solver.steps() < until) solver.step(1);
  return solver;
}

}  // namespace scree::test::granular_box
