// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/symmetric.hpp"
#include "../fields/standard.hpp"
#include "../pairs/term.hpp"

namespace scree {

/// L_ab = du_a/dx_b.
struct VelocityGradient : Tensor<"velocity gradient", "1/s"> {};
inline constexpr VelocityGradient velocity_gradient{};

/// sum_j V_j x_ij (x) gradW_ij: minus the identity where the support is full.
struct FirstMoment : Tensor<"first moment of the kernel gradient", "1"> {};
inline constexpr FirstMoment first_moment{};

/// L_i = sum_j V_j (u_j - u_i) (x) gradW_ij (Zhu et al. 2024, eqs 3.14 and 3.15 with the order of the difference
/// mended).
struct VelocityGradientSum {
  using reads = Fields<Volume, Velocity>;
  using adds = Fields<VelocityGradient>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    sum[velocity_gradient] += j[volume] * (j[velocity] - i[velocity]) * ij.gradW().transpose();
  }
};

/// The first moment of the kernel gradient over the particles at hand.
struct FirstMomentSum {
  using reads = Fields<Volume>;
  using adds = Fields<FirstMoment>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    sum[first_moment] += j[volume] * ij.x * ij.gradW().transpose();
  }
};

/// gamma_dot = sqrt(2 e:e) with the deviator e of the symmetric part of L; the deviator is taken in three dimensions,
/// so that 2D is plane strain.
template <int Dim, class Real>
SCREE_FN Real shear_rate_of(Mat<Dim, Real> const& L) {
  Mat<Dim, Real> const rate = (L + L.transpose()) / 2;
  Real const volumetric = rate.trace();
  return Kokkos::sqrt(Kokkos::max(Real(0), 2 * (rate.squaredNorm() - sq(volumetric) / 3)));
}

/// Shear rate from a velocity gradient made exact for linear velocities, G with G M = L, M = -sum_j V_j x_ij (x)
/// gradW_ij (symmetric), so that a truncated support does not lower it. A particle with too few neighbours keeps the
/// plain gradient.
struct CorrectedShearRate {
  using reads = Fields<>;
  using writes = Fields<ShearRate>;
  static constexpr bool stores_sums = false;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    using Matrix = std::remove_cvref_t<decltype(total[velocity_gradient])>;
    using Real = typename Matrix::Scalar;
    constexpr int dim = Matrix::RowsAtCompileTime;
    Matrix const L = total[velocity_gradient], M = -total[first_moment];
    Matrix G = L;
    for (int axis = 0; axis < dim; ++axis) {
      Vec<dim, Real> row = L.row(axis).transpose();
      solve_positive_definite<dim, Real>(M, row, Real(1e-3), row);
      G.row(axis) = row.transpose();
    }
    out[shear_rate] = shear_rate_of(G);
  }
};

}  // namespace scree
