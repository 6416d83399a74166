// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/basis.hpp"
#include "../fields/rate.hpp"

namespace scree {
namespace detail {

template <class P, class List>
struct MidpointPredictor;
template <class P, class... Fs>
struct MidpointPredictor<P, Fields<Fs...>> {
  using fields = evolved_fields<Fields<Fs...>>;
  using reads = Merge<fields, rates_of_evolved<Fields<Fs...>>, remainders_of_evolved<P, Fields<Fs...>>>;
  using writes = Merge<fields, Fields<Previous<evolved_field<Fs>>...>>;
  typename time_for<P, Fields<Fs...>>::type half_step;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    (start<Fs>(i, out), ...);
  }

 private:
  /// Predicts a field. Remainders keep their values from the beginning of the step.
  template <class Entry, class I, class O>
  SCREE_FN void start(I const& i, O& out) const {
    using F = evolved_field<Entry>;
    auto const by = change<Entry>(half_step, i);
    out[Previous<F>{}] = i[F{}];
    if constexpr (OneOf<Remainder<F>, reads>)
      out[F{}] = compensated_sum(i[F{}], i[Remainder<F>{}], by).value;
    else
      out[F{}] = i[F{}] + by;
  }
};

template <class P, class List>
struct MidpointCorrector;
template <class P, class... Fs>
struct MidpointCorrector<P, Fields<Fs...>> {
  using remainders = remainders_of_evolved<P, Fields<Fs...>>;
  using reads = Merge<Fields<Previous<evolved_field<Fs>>...>, rates_of_evolved<Fields<Fs...>>, remainders>;
  using writes = Merge<evolved_fields<Fields<Fs...>>, remainders>;
  typename time_for<P, Fields<Fs...>>::type step;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    (evolve<P, Fs>(i[Previous<evolved_field<Fs>>{}], change<Fs>(step, i), i, out), ...);
  }
};

template <class List>
struct rates_and_previous;
template <class... Fs>
struct rates_and_previous<Fields<Fs...>> {
  using type =
      Merge<evolved_fields<Fields<Fs...>>, rates_of_evolved<Fields<Fs...>>, Fields<Previous<evolved_field<Fs>>...>>;
};

}  // namespace detail

/// The second-order predictor-corrector scheme for all evolved fields of a formulation (Zhu et al. 2024, eqs 3.17 and
/// 3.18, eq. 3.17 with half a step): $X^{n+1/2} = X^n + \tfrac{1}{2} dt\, \Gamma^n$, $X^{n+1} = X^n + dt\,
/// \Gamma^{n+1/2}$.
struct Midpoint {
  static constexpr char const* name = "Midpoint";
  /// The largest cfl. An elastic wave of frequency omega grows by $\sqrt{1 + (\omega dt)^4/4}$ per step, which
  /// viscosity must offset. In a bed at rest with the default viscosity and filter
  /// (`tests/integrators/largest_cfl.cpp`), the speed of the fastest particle is 0.7 mm/s at cfl 0.2, 1.6 mm/s at 0.3,
  /// 26 mm/s at 0.4 and 0.14 m/s at 0.5; from cfl 0.7 on, the bed swells.
  static constexpr double largest_cfl = 0.3;
  /// The fields that the integrator needs to advance a list of evolved fields.
  template <class Evolved>
  using fields = typename detail::rates_and_previous<Evolved>::type;

  /// Advances the state by one step of at most `longest` (s), and returns its length (s).
  template <class Stepper>
  static double advance(Stepper& stepper, double longest) {
    using P = basis_of<typename Stepper::policy>;
    stepper.update_rates();
    double const dt = stepper.choose_step(longest);
    stepper.update([dt](auto evolved) { return predictor<P>(evolved, dt); }, 0, dt / 2);
    stepper.update_rates();
    stepper.update([dt](auto evolved) { return corrector<P>(evolved, dt); }, dt / 2, dt);
    return dt;
  }

  /// Returns the function of one particle that takes the state from t to t + dt/2, with the rates at t.
  template <class P, class Evolved>
  static detail::MidpointPredictor<P, Evolved> predictor(Evolved, double dt) {
    return {typename detail::time_for<P, Evolved>::type(dt / 2)};
  }
  /// Returns the function of one particle that takes the state from t to t + dt, with the rates at t + dt/2.
  template <class P, class Evolved>
  static detail::MidpointCorrector<P, Evolved> corrector(Evolved, double dt) {
    return {typename detail::time_for<P, Evolved>::type(dt)};
  }
};

}  // namespace scree
