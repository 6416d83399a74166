// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../pairs/for_each_particle.hpp"

namespace scree {
namespace detail {

template <class P, class List>
struct MidpointPredictor;
template <class P, class... Fs>
struct MidpointPredictor<P, Fields<Fs...>> {
  using reads = Fields<Fs..., typename Fs::rate...>;
  using writes = Fields<Fs..., Previous<Fs>...>;
  typename P::real half_step;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    ((out[Previous<Fs>{}] = i[Fs{}], out[Fs{}] = i[Fs{}] + half_step * i[typename Fs::rate{}]), ...);
  }
};

template <class P, class List>
struct MidpointCorrector;
template <class P, class... Fs>
struct MidpointCorrector<P, Fields<Fs...>> {
  using reads = Fields<Previous<Fs>..., typename Fs::rate...>;
  using writes = Fields<Fs...>;
  typename P::real step;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    ((out[Fs{}] = i[Previous<Fs>{}] + step * i[typename Fs::rate{}]), ...);
  }
};

template <class List>
struct rates_and_previous;
template <class... Fs>
struct rates_and_previous<Fields<Fs...>> {
  using type = Fields<Fs..., typename Fs::rate..., Previous<Fs>...>;
};

}  // namespace detail

/// Second-order predictor-corrector for all fields a formulation evolves (Zhu et al. 2024, eqs 3.17 and 3.18, the first
/// with half a step): X^{n+1/2} = X^n + dt/2 Gamma^n, X^{n+1} = X^n + dt Gamma^{n+1/2}.
struct Midpoint {
  /// Fields the scheme needs for a list of evolved ones.
  template <class Evolved>
  using fields = typename detail::rates_and_previous<Evolved>::type;

  /// From the state and rates at t to the state at t + dt/2.
  template <class P, class Evolved, class Body>
  static void predict(Body const& body, Evolved, double dt) {
    using Step = detail::MidpointPredictor<P, Evolved>;
    for_each_particle<P>("scree::predict", body, Step{typename P::real(dt / 2)});
  }
  /// From the rates at t + dt/2 to the state at t + dt.
  template <class P, class Evolved, class Body>
  static void correct(Body const& body, Evolved, double dt) {
    using Step = detail::MidpointCorrector<P, Evolved>;
    for_each_particle<P>("scree::correct", body, Step{typename P::real(dt)});
  }
};

}  // namespace scree
