// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "circular_cone.hpp"
#include "mu_of_i.hpp"
#include "response.hpp"

#include <type_traits>

namespace scree {

/// A frictional law whose strength depends on the intermediate principal stress as that of sand does: the circular cone
/// of the law becomes the surface of Matsuoka & Nakai (1974), $I_1 I_2/I_3$ constant, which touches it in plane shear.
/// There nothing changes; in triaxial compression the material is stronger and in extension weaker than the cone, so
/// that its friction angle is the same in both. It is meant for sand that is loaded from all sides: round heaps,
/// columns and footings in space. Flow stays isochoric and keeps the direction of the deviator.
///
/// All other functions are inherited from the law, which is the base class and comes first:
/// MatsuokaNakai<MuOfI<>>{{.elastic = ..., .grains = ...}}. Ratios k of 1 and more count as 1, where the friction angle
/// is a right one; friction_ratio() stays below $\sqrt{3}/2$.
template <class Law>
struct MatsuokaNakai : Law {
  static_assert(
      detail::OnCircularCone<Law> && std::is_same_v<typename Law::history, Fields<>>,
      "the law in MatsuokaNakai needs a function shear_strength(p, point), in Pa, no internal variables and a "
      "constant `cohesionless` = true, as MuOfI has them");

  static constexpr bool circular = false;  ///< whether the strength is that of a circular cone

  /// Throws std::invalid_argument where a parameter of the law is out of range or the law bears tension.
  void check() const {
    check_settings_of(static_cast<Law const&>(*this));
    detail::check_response(static_cast<Law const&>(*this));
  }
  /// The largest $\sqrt{J_2}$ at a pressure p (Pa), that of triaxial compression.
  template <class Real, class Point>
  SCREE_FN Real shear_strength(Real p, Point const& point) const {
    return p > 0 ? strength_ratio(p, point, Real(1)) * p : Law::shear_strength(p, point);
  }
  /// The return mapping at a constant pressure, along the deviator.
  template <class Real, class Point, class History>
  SCREE_FN StressTensor<Real> admissible(StressTensor<Real> const& trial, Point const& point, History&&) const {
    return return_to_cone(trial, strength_ratio(pressure_of(trial), point, cosine_of_lode_angle(deviator_of(trial))));
  }

 private:
  /// $\sqrt{J_2}/p$ on the surface.
  template <class Real, class Point>
  SCREE_FN Real strength_ratio(Real p, Point const& point, Real cosine) const {
    return matsuoka_nakai_ratio(Law::shear_strength(p, point) / p, cosine);
  }
};

}  // namespace scree
