// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "law.hpp"

// How far the strength of sand is from that of a circular cone, where sand is not in plane shear.
namespace scree {
namespace detail {
/// A cohesionless law whose strength is that of a circular cone, $\sqrt{J_2} \le k p$.
template <class Law>
concept OnCircularCone = Cohesionless<Law> && !requires {
  requires !Law::circular;
}
&&requires(Law const& law, double p, PointOf<Law> const& point) {
  { law.shear_strength(p, point) } -> std::convertible_to<double>;
};
}  // namespace detail

/// $\cos 3\theta$ of a deviator, $(3 \sqrt{3}/2) J_3/J_2^{3/2}$ with compression positive: 1 in triaxial compression,
/// 0 in plane shear, -1 in triaxial extension; 0 without shear.
template <class Real>
SCREE_FN Real cosine_of_lode_angle(StressTensor<Real> const& s) {
  StressTensor<Real> const direction = s / equivalent_shear_stress(s);
  Real const cosine = -Real(1.5 * 1.7320508075688772 / 3) * dot(direction * direction, direction);
  return cosine > -1 ? Kokkos::min(cosine, Real(1)) : cosine <= -1 ? Real(-1) : Real(0);
}

/// $\sqrt{J_2}/p$ on the surface of Matsuoka & Nakai (1974) that touches the cone of a ratio k in plane shear: y k with
/// the root of $y^2 - a y^3 = 1$ that is 1 for a = 0, and $a = \cos(3\theta)\, k (3 - k^2)/(3 \sqrt{3})$. Ratios above
/// 1 count as 1.
template <class Real>
SCREE_FN Real matsuoka_nakai_ratio(Real k, Real cosine) {
  Real const bounded = k > 1 ? Real(1) : k;
  Real const bent = bounded * (3 - sq(bounded)) / 2 * cosine;
  return bounded * Real(0.8660254037844386) / Kokkos::cos(Kokkos::acos(-bent) / 3);
}

}  // namespace scree
