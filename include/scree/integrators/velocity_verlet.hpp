// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "update.hpp"

#include <tuple>
#include <utility>

namespace scree {

/// The velocity Verlet scheme (kick, drift, kick) with one evaluation of each pass per step (Swope et al. 1982):
/// $u^{n+1/2} = u^n + \tfrac{1}{2} dt\, a^n$, $x^{n+1} = x^n + dt\, u^{n+1/2}$, $u^{n+1} = u^{n+1/2} + \tfrac{1}{2}
/// dt\, a^{n+1}$. The last stage of the physics model must evolve velocity and position. Earlier stages, for instance
/// the stage of the stress, are advanced with the positions after half the drift, which makes them second-order as
/// well. Velocity-dependent terms of the last stage (viscosity) use u^{n+1/2}. $a^n$ is the acceleration that was
/// computed in the preceding step, so a change of the stress by a filter takes effect only in the second kick.
struct VelocityVerlet {
  static constexpr char const* name = "VelocityVerlet";
  /// The largest cfl, the same as for SymplecticEuler.
  static constexpr double largest_cfl = 1;
  static constexpr bool staggered = true;
  /// The fields that the integrator needs to advance a list of evolved fields.
  template <class Evolved>
  using fields = Merge<evolved_fields<Evolved>, rates_of_evolved<Evolved>>;

  /// Advances the state by one step of at most `longest` (s), and returns its length (s).
  template <class Stepper>
  static double advance(Stepper& stepper, double longest) {
    if (stepper.steps() == 0) stepper.update_rates();
    double const dt = stepper.choose_step(longest);
    auto const stages = stepper.stages(dt);
    using Stages = std::remove_cvref_t<decltype(stages)>;
    constexpr std::size_t last = std::tuple_size_v<Stages> - 1;
    static_assert(detail::positions_last<Stages>, "positions must be evolved by the last stage");
    static_assert(std::is_same_v<typename std::tuple_element_t<last, Stages>::evolves, Fields<Velocity, Position>>,
                  "the last stage must evolve Fields<Velocity, Position>: this scheme is made of kicks and drifts");

    stepper.add_rates(Fields<Velocity, Position>{}, dt / 2);
    stepper.move(0, dt / 2);
    between(stepper, stages, dt, std::make_index_sequence<last>());
    stepper.add_rates(Fields<Position>{}, dt / 2);
    stepper.move(dt / 2, dt);
    stepper.evaluate(std::get<last>(stages));
    stepper.add_rates(Fields<Velocity>{}, dt / 2);
    stepper.project(std::get<last>(stages));
    return dt;
  }

 private:
  template <class Stepper, class Stages, std::size_t... K>
  static void between(Stepper& stepper, [[maybe_unused]] Stages const& stages, [[maybe_unused]] double dt,
                      std::index_sequence<K...>) {
    (stepper.advance(std::get<K>(stages), dt), ...);
  }
};

}  // namespace scree
