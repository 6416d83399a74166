// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "closure.hpp"

#include <cmath>

namespace scree {

/// V = chi_V gamma_dot d_avg, D = chi_D gamma_dot d_avg^2 with d_avg = d_S C + d_L (1 - C): Zhu et al. (2024), eq. 2.7.
struct ShearRateClosure {
  double chi_V = 0.11;    ///< -
  double chi_D = 0.0307;  ///< -
  double d_small = 0;     ///< diameter of small grains, m
  double d_large = 0;     ///< diameter of large grains, m

  using reads = Fields<Concentration, ShearRate>;
  using writes = Fields<SegregationVelocity, Diffusivity>;
  /// Throws std::invalid_argument where a parameter is out of range.
  void check() const {
    check_setting(chi_V >= 0 && std::isfinite(chi_V), "chi_V (-) of the closure", chi_V, "0 or more");
    check_setting(chi_D >= 0 && std::isfinite(chi_D), "chi_D (-) of the closure", chi_D, "0 or more");
    check_setting(d_small > 0 && std::isfinite(d_small), "d_small (m) of the closure", d_small, "above 0");
    check_setting(d_large > 0 && std::isfinite(d_large), "d_large (m) of the closure", d_large, "above 0");
  }
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    auto const C = i[concentration];
    auto const d = d_small * C + d_large * (1 - C);
    out[segregation_velocity] = chi_V * i[shear_rate] * d;
    out[diffusivity] = chi_D * i[shear_rate] * d * d;
  }
};

}  // namespace scree
