// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "law.hpp"
#include "response.hpp"

#include <cmath>

namespace scree {

/// A law with its tension limited to p >= -tensile_strength. Beyond this limit the material opens: plastic flow is
/// purely volumetric, so the deviator of the trial stress is kept, or reduced to the shear strength of the law at the
/// limit if the deviator exceeds this strength. All other functions are inherited from the law, which is the base class
/// and is initialised first: TensionCutoff<DruckerPrager>{{.elastic = ..., .cone = ...}, 500}.
template <class Law>
struct TensionCutoff : Law {
  double tensile_strength = 0;  ///< T, 0 or more, Pa

  static constexpr auto parameters() {
    return std::array{
        parameter("tensile_strength", &TensionCutoff::tensile_strength, "Pa", "largest tension", allowed::at_least(0))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const {
    check_settings_of(static_cast<Law const&>(*this));
    detail::check_response(static_cast<Law const&>(*this));
    check_parameters(*this, "TensionCutoff");
  }
  /// Returns the shear strength (Pa) of the law at a pressure p (Pa), and 0 if the tension exceeds the tensile
  /// strength.
  template <class Real, class Point>
  SCREE_FN Real shear_strength(Real p, Point const& point) const {
    return p < -Real(tensile_strength) ? Real(0) : Law::shear_strength(p, point);
  }
  /// Returns the stress of the law; if its tension exceeds the tensile strength, the pressure is set to minus the
  /// tensile strength.
  template <class Real, class Point, class History>
  SCREE_FN StressTensor<Real> admissible(StressTensor<Real> const& trial, Point const& point, History&& memory) const {
    static_assert(
        requires(Law const& law, Real p) { law.shear_strength(p, point); },
        "the law in TensionCutoff needs a function shear_strength(p, point), in Pa");
    Real const least = -Real(tensile_strength);
    StressTensor<Real> const borne = Law::admissible(trial, point, memory);
    // If the stress is NaN, it is returned unchanged.
    if (!(pressure_of(borne) < least)) return borne;
    StressTensor<Real> const s = deviator_of(trial);
    Real const tau = equivalent_shear_stress(s), strength = Law::shear_strength(least, point);
    Real const scale = tau > strength ? strength / tau : Real(1);
    return scale * s - least * identity_matrix<StressTensor<Real>>();
  }
};

}  // namespace scree
