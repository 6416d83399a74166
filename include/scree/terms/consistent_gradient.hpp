// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "gradient.hpp"

#include <Eigen/LU>

namespace scree {

/// The matrix of the moments of the kernel and its gradient for a C1-consistent gradient, $\begin{pmatrix}
/// \sum V W & -\sum V W x_{ij}^T \\ \sum V \nabla W & -\sum V \nabla W \otimes x_{ij} \end{pmatrix}$ (Zhu et al. 2024,
/// eqs E11 to E14).
struct ConsistencyMatrix : Labelled<"consistency matrix", "1, m, 1/m, 1"> {
  template <int Dim, class Real>
  using value = Mat<Dim + 1, Real>;
};

namespace fields {
inline constexpr ConsistencyMatrix consistency_matrix{};
}  // namespace fields

/// The vector $\sum_j X_j V_j (W, \nabla W)$ for a C1-consistent gradient (Zhu et al. 2024, eqs E9 and E10).
template <Field F>
struct ConsistencyVector : Labelled<"consistency vector", "as the field"> {
  template <int Dim, class Real>
  using value = Vec<Dim + 1, Real>;
};

/// The sum for the consistency matrix, including the particle itself.
struct ConsistencyMatrixSum {
  using reads = Fields<Volume>;
  using adds = Fields<ConsistencyMatrix>;
  static constexpr bool takes_packs = true;
  static constexpr bool includes_self = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    using Real = typename IJ::real;
    // With lengths in units of h, all entries are of order one.
    auto const test = joined(ij.W(), ij.h() * ij.gradW()), trial = joined(Real(1), -ij.x / ij.h());
    sum[consistency_matrix] += outer(j[volume] * test, trial);
  }
};
/// The sum for the consistency vector of a field, including the particle itself.
template <Field F>
struct ConsistencyVectorSum {
  using reads = Fields<Volume, F>;
  using adds = Fields<ConsistencyVector<F>>;
  static constexpr bool takes_packs = true;
  static constexpr bool includes_self = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    auto const test = joined(ij.W(), ij.h() * ij.gradW());
    // Differences from the value of i preserve precision if the field is nearly uniform.
    sum[ConsistencyVector<F>{}] += j[fields::volume] * (j[F{}] - i[F{}]) * test;
  }
};

/// Returns the gradient from the consistency matrix and vector, in units of the field per m; h is in m. Returns zero if
/// the matrix is nearly singular.
template <class M, class B>
SCREE_FN auto consistent_gradient(M const& matrix, B const& vector, double h) {
  using Real = typename M::Scalar;
  constexpr int dim = M::RowsAtCompileTime - 1;
  Vec<dim, Real> result = zero<Vec<dim, Real>>();
  if (!(Kokkos::abs(matrix.determinant()) > Real(1e-5))) return result;
  B const solution = matrix.inverse() * vector;
  for (int axis = 0; axis < dim; ++axis) result[axis] = solution[axis + 1] / Real(h);
  return result;
}

/// The C1-consistent gradient, from one linear system for the value and the gradient, which is exact for linear fields
/// on any set of neighbours that spans the space (Liu & Liu; Zhu et al. 2024, appendix E). The gradient is zero for a
/// particle whose neighbours do not span the space.
template <Field F>
struct ConsistentGradient {
  double h;  ///< smoothing length, m
  using reads = Fields<>;
  using writes = Fields<Gradient<F>>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    using namespace fields;
    out[gradient<F>] = consistent_gradient(total[consistency_matrix], total[ConsistencyVector<F>{}], h);
  }
};

}  // namespace scree
