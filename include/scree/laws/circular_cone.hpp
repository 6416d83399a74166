// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "law.hpp"

namespace scree {

/// The section of a circular cone, $\sqrt{J_2} = k p$ in all directions, as in Zhu et al. (2024).
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
/// Whether a law is cohesionless with the strength $\sqrt{J_2} \le k p$ in plane shear, and in all directions unless it
/// takes a section. A law with a yield surface of another shape has a constant `circular` = false.
template <class Law>
concept OnCircularCone = Cohesionless<Law> && !requires {
  requires !Law::circular;
}
&&requires(Law const& law, double p, PointOf<Law> const& point) {
  { law.shear_strength(p, point) } -> std::convertible_to<double>;
};
}  // namespace detail

}  // namespace scree
