// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "section.hpp"

namespace scree {

/// The section of the surface of Matsuoka & Nakai (1974), $I_1 I_2/I_3$ constant, which touches the circular cone in
/// plane shear: in triaxial compression the material is stronger and in extension weaker than the cone, so that its
/// friction angle is the same in both, as that of sand is. Ratios k of 1 and more count as 1, where the friction angle
/// is a right one; friction_ratio() stays below $\sqrt{3}/2$.
struct MatsuokaNakai {
  /// y k with the root of $y^2 - a y^3 = 1$ that is 1 for a = 0, and $a = \cos(3\theta)\, k (3 - k^2)/(3 \sqrt{3})$.
  template <class Real>
  SCREE_FN Real ratio(Real k, Real cosine) const {
    Real const bounded = k > 1 ? Real(1) : k;
    Real const bent = bounded * (3 - sq(bounded)) / 2 * cosine;
    return bounded * Real(0.8660254037844386) / Kokkos::cos(Kokkos::acos(-bent) / 3);
  }
  /// k times $\sqrt{3}/2$, which y does not fall below.
  template <class Real>
  SCREE_FN Real least_ratio(Real k) const {
    return (k > 1 ? Real(1) : k) * Real(0.8660254037844386);
  }
};

}  // namespace scree
