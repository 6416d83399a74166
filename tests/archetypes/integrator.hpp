// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/formulation/formulation.hpp>
#include <scree/integrators/update.hpp>

namespace scree::test::archetypes {

/// Euler's method.
struct Integrator {
  template <class Evolved>
  using fields = Merge<evolved_fields<Evolved>, rates_of_evolved<Evolved>>;
  template <class Stepper>
  static double advance(Stepper& stepper, double longest) {
    using Evolved = typename Stepper::policy::physics::evolves;
    stepper.update_rates();
    double const dt = stepper.choose_step(longest);
    stepper.update(staggered_update<typename Stepper::Basis>(Evolved{}, dt), 0, dt);
    return dt;
  }
};
static_assert(TimeIntegrator<Integrator, Fields<Velocity, Position>>);

}  // namespace scree::test::archetypes
