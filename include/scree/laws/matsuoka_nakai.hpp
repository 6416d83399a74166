// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "section.hpp"

namespace scree {

/// The section of the yield surface of Matsuoka & Nakai (1974), $I_1 I_2/I_3$ constant, which touches the circular cone
/// in plane shear. In triaxial compression the material is stronger than the cone and in triaxial extension weaker, so
/// that its friction angle is the same in both, as for sand. Ratios k above 1 are taken as 1, at which the friction
/// angle is 90 degrees; friction_ratio() stays below $\sqrt{3}/2$.
struct MatsuokaNakai {
  /// Returns y k, with y the root of $y^2 - a y^3 = 1$ that is 1 for a = 0, and $a = \cos(3\theta)\, k (3 - k^2)/(3
  /// \sqrt{3})$.
  template <class Real>
  SCREE_FN Real ratio(Real k, Real cosine) const {
    Real const bounded = k > 1 ? Real(1) : k;
    Real const bent = bounded * (3 - sq(bounded)) / 2 * cosine;
    return bounded * Real(0.8660254037844386) / Kokkos::cos(Kokkos::acos(-bent) / 3);
  }
  /// Returns $k \sqrt{3}/2$: y is at least $\sqrt{3}/2$.
  template <class Real>
  SCREE_FN Real least_ratio(Real k) const {
    return (k > 1 ? Real(1) : k) * Real(0.8660254037844386);
  }
};

}  // namespace scree
