// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "closure.hpp"

namespace scree {

/// Constant V and D (Van der Vaart et al. 2015).
struct ConstantClosure {
  double velocity = 0;     ///< V, m/s
  double diffusivity = 0;  ///< D, m^2/s

  using reads = Fields<>;
  using writes = Fields<SegregationVelocity, Diffusivity>;
  static constexpr auto parameters() {
    return std::array{parameter("velocity", &ConstantClosure::velocity, "m/s", "constant velocity V of segregation",
                                allowed::at_least(0)),
                      parameter("diffusivity", &ConstantClosure::diffusivity, "m^2/s", "constant diffusivity D",
                                allowed::at_least(0))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const { check_parameters(*this, "ConstantClosure"); }
  template <class I, class O>
  SCREE_FN void operator()(I const&, O& out) const {
    using namespace fields;
    using Real = std::remove_cvref_t<decltype(out[segregation_velocity])>;
    out[segregation_velocity] = Real(velocity);
    out[fields::diffusivity] = Real(diffusivity);
  }
};

}  // namespace scree
