// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "closure.hpp"

namespace scree {

/// V and D in proportion to the shear rate: $V = \chi_V \dot\gamma d_{\mathrm{avg}}$, $D = \chi_D \dot\gamma
/// d_{\mathrm{avg}}^2$ with d_avg = d_S C + d_L (1 - C) (Zhu et al. 2024, eq. 2.7).
struct ShearRateClosure {
  double chi_V = 0.11;
  double chi_D = 0.0307;
  double d_small = 0;
  double d_large = 0;

  using reads = Fields<Concentration, ShearRate>;
  using writes = Fields<SegregationVelocity, Diffusivity>;
  static constexpr auto parameters() {
    return std::array{
        parameter("chi_V", &ShearRateClosure::chi_V, "1", "V = chi_V shear rate d", allowed::at_least(0)),
        parameter("chi_D", &ShearRateClosure::chi_D, "1", "D = chi_D shear rate d^2", allowed::at_least(0)),
        parameter("d_small", &ShearRateClosure::d_small, "m", "diameter of the small grains", allowed::above(0)),
        parameter("d_large", &ShearRateClosure::d_large, "m", "diameter of the large grains", allowed::above(0))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const { check_parameters(*this, "the closure"); }
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    using Real = std::remove_cvref_t<decltype(out[diffusivity])>;
    auto const C = i[concentration];
    auto const d = d_small * C + d_large * (1 - C);
    out[segregation_velocity] = Real(chi_V * i[shear_rate] * d);
    out[diffusivity] = Real(chi_D * i[shear_rate] * d * d);
  }
};

}  // namespace scree
