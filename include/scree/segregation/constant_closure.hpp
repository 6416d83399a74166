// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "closure.hpp"

#include <cmath>

namespace scree {

/// Constant V and D (Van der Vaart et al. 2015).
struct ConstantClosure {
  double velocity = 0;     ///< V, m/s
  double diffusivity = 0;  ///< D, m^2/s

  using reads = Fields<>;
  using writes = Fields<SegregationVelocity, Diffusivity>;
  /// Throws std::invalid_argument where a parameter is out of range.
  void check() const {
    check_setting(velocity >= 0 && std::isfinite(velocity), "velocity (m/s) of segregation", velocity, "0 or more");
    check_setting(diffusivity >= 0 && std::isfinite(diffusivity), "diffusivity (m^2/s)", diffusivity, "0 or more");
  }
  template <class I, class O>
  SCREE_FN void operator()(I const&, O& out) const {
    out[segregation_velocity] = velocity;
    out[scree::diffusivity] = diffusivity;
  }
};

}  // namespace scree
