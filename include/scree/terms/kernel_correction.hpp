// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/symmetric.hpp"
#include "gradient.hpp"

// The kernel-gradient correction (Randles & Libersky 1996; Bonet & Lok 1999): with M_i = -sum_j V_j x_ij (x) gradW_ij,
// which is the identity if the support is full and regular, the corrected kernel gradient M_i^-1 gradW_ij gives exact
// gradients of linear fields. The correction is applied to the sum, once per particle.
namespace scree {

/// The first moment of the kernel gradient, $\sum_j V_j x_{ij} \otimes \nabla W_{ij} = -M_i$, a symmetric tensor.
struct FirstMoment : Tensor<"first moment of the kernel gradient", "1"> {};

namespace fields {
inline constexpr FirstMoment first_moment{};
}  // namespace fields

/// The sum for the first moment of the kernel gradient.
struct FirstMomentSum {
  using reads = Fields<Volume>;
  using adds = Fields<FirstMoment>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    sum[first_moment] += outer(j[volume] * ij.x, ij.gradW());
  }
};

/// Returns the gradient g of a scalar with M g = `plain`, or the gradient G of a vector with G M = `plain`, in which
/// each column holds the derivatives along one axis. If the neighbours do not span the space, `plain` is returned
/// unchanged.
template <class Plain, class Matrix>
SCREE_FN Plain corrected_gradient(Plain const& plain, Matrix const& moment) {
  using Real = typename Matrix::Scalar;
  constexpr int dim = Matrix::RowsAtCompileTime;
  Matrix const M = -moment;
  if constexpr (Plain::ColsAtCompileTime == 1) {
    Plain corrected = plain;
    solve_positive_definite<dim, Real>(M, plain, Real(1e-3), corrected);
    return corrected;
  } else {
    Plain const columns = transposed(plain);
    Plain corrected = columns;
    solve_positive_definite<dim, Real>(M, columns, Real(1e-3), corrected);
    return transposed(corrected);
  }
}

/// The corrected gradient of a scalar field, from PlainGradient and FirstMomentSum.
template <Field F>
struct CorrectedGradient {
  using reads = Fields<>;
  using writes = Fields<Gradient<F>>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    using namespace fields;
    out[gradient<F>] = corrected_gradient(total[gradient<F>], total[first_moment]);
  }
};

}  // namespace scree
