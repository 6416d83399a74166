// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "section.hpp"

#include <cmath>

namespace scree {

/// The cone of stresses $\sqrt{J_2} \le k p + k_c$ with friction k and cohesion k_c, and the plastic potential
/// $\sqrt{J_2} - k_\psi p$ with dilatancy k_psi.
template <class Real>
struct Cone {
  Real friction = 0;   ///< k, 0 to $\sqrt{3}$, which no friction angle below 90 degrees exceeds, -
  Real cohesion = 0;   ///< k_c, 0 or more, Pa
  Real dilatancy = 0;  ///< k_psi, 0 (isochoric flow) to k (associated flow), -

  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const {
    check_setting(
        friction >= 0 && friction <= Real(1.7320509), "friction (-) of the cone", double(friction),
        "from 0 to 1.732, the root of J2 over the pressure and not an angle: plane_strain_cone() makes it from "
        "a friction angle (rad)");
    check_setting(cohesion >= 0 && std::isfinite(cohesion), "cohesion (Pa) of the cone", double(cohesion), "0 or more");
    check_setting(dilatancy >= 0 && dilatancy <= friction * (1 + 1e-12), "dilatancy (-) of the cone", double(dilatancy),
                  "from 0 to its friction");
  }
  /// Returns this cone in another floating-point type.
  template <class To>
  SCREE_FN Cone<To> cast() const {
    return {To(friction), To(cohesion), To(dilatancy)};
  }
};

/// Returns a trial stress to a cone in one step along the plastic flow direction. The step is exact because yield
/// surface and plastic potential are cones: the deviator keeps its direction, $\sqrt{J_2}$ decreases by G dlambda, and
/// p increases by K k_psi dlambda. A stress that would end beyond the apex of the cone returns to the apex, p = -k_c/k.
/// A trial stress that is not finite gives zero stress. See Zhu et al. (2024), section 2.4 and appendix C, where k_c =
/// k_psi = 0, and de Souza Neto et al. (2008), section 8.3.2. `shear_to_bulk` is G/K, above zero; it matters only if
/// k_psi > 0.
template <class Real>
SCREE_FN StressTensor<Real> return_to_cone(StressTensor<Real> const& trial, Cone<Real> const& cone,
                                           Real shear_to_bulk) {
  Real const p = pressure_of(trial);
  StressTensor<Real> const s = deviator_of(trial);
  Real const tau = equivalent_shear_stress(s), excess = tau - (cone.friction * p + cone.cohesion);
  // Comparisons with NaN are false, so NaN fails all of these conditions and reaches the last line.
  if (excess <= 0) return trial;
  Real const raised = p + cone.dilatancy * excess / (shear_to_bulk + cone.friction * cone.dilatancy);
  Real const strength = cone.friction * raised + cone.cohesion;
  if (strength >= 0 && Kokkos::isfinite(tau)) {
    Real const scale = tau > 0 ? strength / tau : Real(0);  // at the apex rounding can leave strength > 0 with tau = 0
    return scale * s - raised * identity_matrix<StressTensor<Real>>();
  }
  if (strength < 0) return identity_matrix<StressTensor<Real>>() * (cone.cohesion / cone.friction);
  return zero<StressTensor<Real>>();
}

/// Returns a trial stress, at constant pressure, to the cone $\sqrt{J_2} = k p$ without cohesion and dilatancy. The
/// result is zero if the pressure is not positive, even without friction (k = 0).
template <class Real>
SCREE_FN StressTensor<Real> return_to_cone(StressTensor<Real> const& trial, Real k) {
  if (pressure_of(trial) <= 0) return zero<StressTensor<Real>>();
  return return_to_cone(trial, Cone<Real>{k, 0, 0}, Real(1));
}

/// Returns a trial stress, at constant pressure and along its deviator, to the frictional yield surface with the
/// section of a point and $\sqrt{J_2} = k p$ in plane shear; the section is a circular cone if the point names none.
/// The direction of the deviator does not change, so one step is exact. The result is zero if the pressure is not
/// positive.
template <class Real, class Point>
SCREE_FN StressTensor<Real> return_to_yield(StressTensor<Real> const& trial, Real k, Point const&) {
  using S = section_at<Point>;
  if constexpr (std::is_same_v<S, CircularCone>) {
    return return_to_cone(trial, k);
  } else {
    Real const p = pressure_of(trial);
    if (p <= 0) return zero<StressTensor<Real>>();
    StressTensor<Real> const s = deviator_of(trial);
    if (equivalent_shear_stress(s) <= S{}.least_ratio(k) * p) return trial;
    return return_to_cone(trial, S{}.ratio(k, cosine_of_lode_angle(s)));
  }
}

}  // namespace scree
