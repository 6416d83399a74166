// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "mu_of_i.hpp"
#include "response.hpp"

#include <type_traits>

namespace scree {
namespace detail {
/// A law of isochoric flow on a circular cone, $\sqrt{J_2} \le k p$, without internal variables.
template <class Law>
concept OnCircularCone = Cohesionless<Law> && std::is_same_v<typename Law::history, Fields<>> && !requires {
  requires !Law::circular;
}
&&requires(Law const& law, double p, PointOf<Law> const& point) {
  { law.shear_strength(p, point) } -> std::convertible_to<double>;
};
}  // namespace detail

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
      detail::OnCircularCone<Law>,
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
  /// $\cos 3\theta$ of a deviator, $(3 \sqrt{3}/2) J_3/J_2^{3/2}$ with compression positive: 1 in triaxial compression,
  /// 0 in plane shear, -1 in triaxial extension; 0 without shear.
  template <class Real>
  SCREE_FN static Real cosine_of_lode_angle(StressTensor<Real> const& s) {
    StressTensor<Real> const direction = s / equivalent_shear_stress(s);
    Real const cosine = -Real(1.5 * 1.7320508075688772 / 3) * dot(direction * direction, direction);
    return cosine > -1 ? Kokkos::min(cosine, Real(1)) : cosine <= -1 ? Real(-1) : Real(0);
  }
  /// $\sqrt{J_2}/p$ on the surface, y k: the root of $y^2 - a y^3 = 1$ that is 1 for a = 0, with
  /// $a = \cos(3\theta)\, k (3 - k^2)/(3 \sqrt{3})$.
  template <class Real, class Point>
  SCREE_FN Real strength_ratio(Real p, Point const& point, Real cosine) const {
    Real const k = Law::shear_strength(p, point) / p, bounded = k > 1 ? Real(1) : k;
    Real const bent = bounded * (3 - sq(bounded)) / 2 * cosine;
    return bounded * Real(0.8660254037844386) / Kokkos::cos(Kokkos::acos(-bent) / 3);
  }
};

}  // namespace scree
