// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "law.hpp"

namespace scree {

/// The section of a circular cone, $\sqrt{J_2} = k p$ in all directions: that of Zhu et al. (2024).
struct CircularCone {
  template <class Real>
  SCREE_FN Real ratio(Real k, Real) const {
    return k;
  }
  template <class Real>
  SCREE_FN Real least_ratio(Real k) const {
    return k;
  }
};

namespace detail {
/// A cohesionless law whose strength is $\sqrt{J_2} \le k p$ in plane shear, and as far as it takes no section in all
/// directions; a law of another shape has a constant `circular` = false.
template <class Law>
concept OnCircularCone = Cohesionless<Law> && !requires {
  requires !Law::circular;
}
&&requires(Law const& law, double p, PointOf<Law> const& point) {
  { law.shear_strength(p, point) } -> std::convertible_to<double>;
};
}  // namespace detail

}  // namespace scree
