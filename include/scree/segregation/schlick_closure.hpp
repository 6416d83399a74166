// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "closure.hpp"

#include <string>

namespace scree {

/// Grains of two sizes and one density: $V = S \dot\gamma d_S \ln(d_L/d_S)$ and $D = A \dot\gamma d_{\mathrm{avg}}^2$
/// with d_avg = d_S C + d_L (1 - C), for the symmetric flux. S = 0.26 comes from simulations of bounded heaps of
/// spheres with ratios d_L/d_S of 1 to 3 (Schlick et al. 2015; Zhu et al. 2024, eq. 5.8); a solver warns if the ratio
/// is above 3. A = 0.042 is the value that published programs use with this S. SizeRatioClosure for two sizes is the
/// same model.
///
/// The equilibrium does not depend on the shear rate: over the height z, $d_L^2 \ln C - d_S^2 \ln(1 - C) - (d_L -
/// d_S)^2 C = -(S/A) d_S \ln(d_L/d_S) z + \text{const}$.
struct SchlickClosure {
  double S = 0.26;
  double A = 0.042;
  double d_small = 0;
  double d_large = 0;

  using reads = Fields<Concentration, ShearRate>;
  using writes = Fields<SegregationVelocity, Diffusivity>;
  static constexpr auto parameters() {
    return std::array{
        parameter("S", &SchlickClosure::S, "1", "V = S shear rate d_small ln(d_large/d_small)", allowed::at_least(0)),
        parameter("A", &SchlickClosure::A, "1", "D = A shear rate d^2", allowed::at_least(0)),
        parameter("d_small", &SchlickClosure::d_small, "m", "diameter of the small grains", allowed::above(0)),
        parameter("d_large", &SchlickClosure::d_large, "m", "diameter of the large grains",
                  allowed::at_least(0, "`d_small` or more"))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const {
    check_parameters(*this, "SchlickClosure");
    check_setting(d_large >= d_small, "d_large (m) of SchlickClosure", d_large, "`d_small` or more");
  }
  /// Returns a warning if the size ratio is beyond the range to which S was fitted; otherwise an empty text.
  std::string warning() const { return warning_of_size_ratio("SchlickClosure", d_large / d_small, 3); }
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    using Real = std::remove_cvref_t<decltype(out[diffusivity])>;
    double const C = double(i[concentration]), rate = double(i[shear_rate]);
    double const d = d_small * C + d_large * (1 - C);
    out[segregation_velocity] = Real(S * rate * d_small * Kokkos::log(d_large / d_small));
    out[diffusivity] = Real(A * rate * d * d);
  }
};

}  // namespace scree
