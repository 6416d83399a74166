// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "formulations.hpp"

#include <scree/motion/oscillating_shear.hpp>
#include <scree/segregation/constant_closure.hpp>
#include <scree/segregation/flux.hpp>

// The oscillating shear box of Zhu, Peng & Wu (2024), section 5, with lengths in H and times in T.
namespace scree::test::shear_box {

inline double const gamma0 = 1 / std::sqrt(3.0);  // tan 30 degrees
inline double const width = 0.4;

/// (5.2) with B = H gamma0: V T/H = 0.03 gamma0, D T/H^2 = 1.01e-3 gamma0^2.
inline ConstantClosure closure() { return {.velocity = 0.03 * gamma0, .diffusivity = 1.01e-3 * sq(gamma0)}; }
inline OscillatingShear motion() { return {.amplitude = gamma0, .period = 1, .floor = 0}; }

/// (5.1): small grains above 1/2; half of each for a particle at 1/2.
inline double layered(double z) { return z < 0.5 - 1e-6 ? 0 : z > 0.5 + 1e-6 ? 1 : 0.5; }

/// A solver of the box at rest, layered. `spacing` must divide width and height.
template <class P>
Solver<P> at_rest(double spacing, typename P::physics const& physics) {
  auto solver = solver_of<P>(open_bed<2>({width, 1}, spacing), spacing, physics, motion());
  set_field(solver, fields::concentration, [](auto const& x) { return layered(x[1]); });
  return solver;
}

/// Runs until a time (T) or until concentrations are further than `too_far` outside [0, 1]; returns how far they were
/// outside at the end of whole periods.
template <class S>
double run_and_watch(S& solver, double until, double too_far) {
  double worst = 0;
  for (int period = 1; period <= until && worst <= too_far; ++period) {
    solver.run(period);
    worst = std::max(worst, outside_of_range(concentrations_of(solver)));
  }
  return worst;
}

}  // namespace scree::test::shear_box
