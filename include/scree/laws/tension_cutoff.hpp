// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "law.hpp"

namespace scree {

/// A law with its tension limited to p >= -tensile_strength. Beyond this limit the material opens: plastic flow is
/// purely volumetric, so the deviator of the trial stress stays, or shrinks to the law's shear strength at that
/// pressure if it yields there too.
template <class Law>
struct TensionCutoff {
  Law law = {};
  double tensile_strength = 0;  ///< T, 0 or more, Pa

  using reads = typename Law::reads;
  using history = typename Law::history;

  void check() const { check_settings_of(law); }
  /// Constants or functions of the state, as the law has them: `state` is the point of a density, sigma and the point
  /// of a stiffness.
  template <class... State>
  SCREE_FN auto density(State const&... state) const -> decltype(law.density(state...)) {
    return law.density(state...);
  }
  template <class... State>
  SCREE_FN auto bulk_modulus(State const&... state) const -> decltype(law.bulk_modulus(state...)) {
    return law.bulk_modulus(state...);
  }
  template <class... State>
  SCREE_FN auto sound_speed(State const&... state) const -> decltype(law.sound_speed(state...)) {
    return law.sound_speed(state...);
  }
  template <class Real, class Point>
  SCREE_FN StressTensor<Real> stress_rate(StressTensor<Real> const& sigma, Mat<3, Real> const& L,
                                          Point const& point) const {
    return law.stress_rate(sigma, L, point);
  }
  template <class Real, class Point, class Rates>
  SCREE_FN void history_rate(StressTensor<Real> const& sigma, Mat<3, Real> const& L, Point const& point,
                             Rates& rates) const requires EvolvesHistory<Law> {
    law.history_rate(sigma, L, point, rates);
  }
  template <class Real, class Point>
  SCREE_FN Real shear_strength(Real p, Point const& point) const {
    return p < -Real(tensile_strength) ? Real(0) : law.shear_strength(p, point);
  }
  template <class Real, class Point, class History>
  SCREE_FN StressTensor<Real> admissible(StressTensor<Real> const& trial, Point const& point, History&& memory) const {
    Real const least = -Real(tensile_strength);
    StressTensor<Real> const borne = law.admissible(trial, point, memory);
    // A NaN stays as the law returned it.
    if (!(pressure_of(borne) < least)) return borne;
    StressTensor<Real> const s = deviator_of(trial);
    Real const tau = equivalent_shear_stress(s), strength = law.shear_strength(least, point);
    Real const scale = tau > strength ? strength / tau : Real(1);
    return scale * s - least * identity_matrix<StressTensor<Real>>();
  }
};

}  // namespace scree
