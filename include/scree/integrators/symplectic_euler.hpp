// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "update.hpp"

#include <tuple>

namespace scree {

/// Runs the stages of the physics model one after another, each with the results of those before it: rates of its
/// fields, their update, projections. With the stages strain and motion: sigma^{n+1} from $(x^n, u^n)$, u^{n+1} from
/// sigma^{n+1}, x^{n+1} from u^{n+1}. First order. For linear oscillations the energy is bounded instead of growing or
/// falling (Hairer, Lubich & Wanner 2003); this does not hold where the rate law is nonlinear in the displacement. One
/// evaluation of each pass per step.
struct SymplecticEuler {
  static constexpr char const* name = "SymplecticEuler";
  /// Elastic waves do not grow: in the bed of Midpoint::largest_cfl the fastest particle has 0.5 mm/s at every cfl
  /// to 1.
  static constexpr double largest_cfl = 1;
  static constexpr bool staggered = true;
  /// Fields the scheme needs for a list of evolved ones.
  template <class Evolved>
  using fields = Merge<evolved_fields<Evolved>, rates_of_evolved<Evolved>>;

  /// One step of at most `longest` (s); returns its length.
  template <class Stepper>
  static double advance(Stepper& stepper, double longest) {
    // The limits of the first step need rates; later steps have them from the step before.
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
