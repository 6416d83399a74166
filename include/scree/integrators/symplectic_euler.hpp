// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "update.hpp"

#include <tuple>

namespace scree {

/// The symplectic Euler scheme. It advances the stages of the physics model one after another, each with the results of
/// the stages before it. For each stage, it computes the rates of the fields of the stage, updates these fields, and
/// runs the projections of the stage. With one stage for the stress and one for the motion, sigma^{n+1} follows from
/// $(x^n, u^n)$, u^{n+1} from sigma^{n+1}, and x^{n+1} from u^{n+1}. The scheme is of first order. In linear
/// oscillations, the energy is bounded and does not drift (Hairer, Lubich & Wanner 2003); this does not hold if the
/// rate law is nonlinear in the displacement. Each pass is evaluated once per step.
struct SymplecticEuler {
  static constexpr char const* name = "SymplecticEuler";
  /// The largest cfl. Elastic waves do not grow: in the bed described at Midpoint::largest_cfl, the speed of the
  /// fastest particle is 0.5 mm/s at every cfl up to 1.
  static constexpr double largest_cfl = 1;
  static constexpr bool staggered = true;
  /// The fields that the integrator needs to advance a list of evolved fields.
  template <class Evolved>
  using fields = Merge<evolved_fields<Evolved>, rates_of_evolved<Evolved>>;

  /// Advances the state by one step of at most `longest` (s), and returns its length (s).
  template <class Stepper>
  static double advance(Stepper& stepper, double longest) {
    // The limits on the first step need rates; the limits on later steps use the rates of the preceding step.
    if (stepper.steps() == 0) stepper.update_rates();
    double const dt = stepper.choose_step(longest);
    auto const stages = stepper.stages(dt);
    static_assert(detail::positions_last<std::remove_cvref_t<decltype(stages)>>,
                  "positions must be evolved by the last stage: the others share one set of neighbours");
    std::apply([&](auto const&... each) { (stepper.advance(each, dt), ...); }, stages);
    if constexpr (!Stepper::evolves_position) stepper.move(0, dt);
    return dt;
  }
};

}  // namespace scree
