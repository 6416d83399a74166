// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/symmetric.hpp"
#include "kernel_correction.hpp"

namespace scree {

/// The symmetric part of the corrected velocity gradient.
struct StrainRate : Symmetric<"strain rate", "1/s"> {};

namespace fields {
inline constexpr StrainRate strain_rate{};
}  // namespace fields

/// The plain velocity gradient $L_i = \sum_j V_j (u_j - u_i) \otimes \nabla W_{ij}$ (Zhu et al. 2024, eqs 3.14 and 3.15
/// with the order of the difference corrected).
struct VelocityGradientSum {
  using reads = Fields<Volume, Velocity>;
  using adds = Fields<VelocityGradient>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    sum[velocity_gradient] += outer(j[volume] * (j[velocity] - i[velocity]), ij.gradW());
  }
};

/// Returns the shear rate $\dot\gamma = \sqrt{2 e:e}$ with the deviator e of the symmetric part of L. The deviator is
/// three-dimensional, so 2D means plane strain.
template <int Dim, class Real>
SCREE_FN Real shear_rate_of(Mat<Dim, Real> const& L) {
  Mat<Dim, Real> const rate = (L + transposed(L)) / 2;
  Real const volumetric = trace(rate);
  return Kokkos::sqrt(Kokkos::max(Real(0), 2 * (squared_norm(rate) - sq(volumetric) / 3)));
}

/// The shear rate from the corrected velocity gradient, which a truncated support does not lower.
struct CorrectedShearRate {
  using reads = Fields<>;
  using writes = Fields<ShearRate>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    using namespace fields;
    out[shear_rate] = shear_rate_of(corrected_gradient(total[velocity_gradient], total[first_moment]));
  }
};

/// The corrected velocity gradient, which is exact for linear velocity fields if the neighbours span the space.
struct CorrectedVelocityGradient {
  using reads = Fields<>;
  using writes = Fields<VelocityGradient>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    using namespace fields;
    out[velocity_gradient] = corrected_gradient(total[velocity_gradient], total[first_moment]);
  }
};

}  // namespace scree
