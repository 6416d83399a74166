// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/integrators/update.hpp>
#include <scree/solver/formulation.hpp>

namespace scree::test::archetypes {

/// Euler's method.
struct Integrator {
  template <class Evolved>
  using fields = Merge<evolved_fields<Evolved>, rates_of_evolved<Evolved>>;
  template <class Solver>
  static double advance(Solver& solver, double longest) {
    using Evolved = typename Solver::policy::physics::evolves;
    solver.update_rates();
    double const dt = solver.choose_step(longest);
    solver.update(staggered_update<typename Solver::Basis>(Evolved{}, dt), 0, dt);
    return dt;
  }
};
static_assert(TimeIntegrator<Integrator, Fields<Velocity, Position>>);

}  // namespace scree::test::archetypes
