// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "types.hpp"

// Symmetric tensors of second order, stored as vectors of their independent entries with off-diagonal entries
// multiplied by sqrt(2) (Mandel notation). The double contraction of two tensors is then the dot product of their
// vectors, and symmetric operators on tensors are symmetric matrices.
namespace scree {

/// Returns $x \otimes x$ in Mandel notation.
template <int Dim, class Real>
SCREE_FN Vec<symmetric_size<Dim>, Real> square_of(Vec<Dim, Real> const& x) {
  Real const root_2 = Real(1.41421356237309505);
  Vec<symmetric_size<Dim>, Real> result;
  int k = Dim;
  for (int a = 0; a < Dim; ++a) {
    result[a] = x[a] * x[a];
    for (int b = a + 1; b < Dim; ++b) result[k++] = root_2 * x[a] * x[b];
  }
  return result;
}

/// Returns (L + L^T)/2 in Mandel notation.
template <int Dim, class Real>
SCREE_FN Vec<symmetric_size<Dim>, Real> symmetric_part(Mat<Dim, Real> const& L) {
  Real const root_half = Real(0.707106781186547524);
  Vec<symmetric_size<Dim>, Real> result;
  int k = Dim;
  for (int a = 0; a < Dim; ++a) {
    result[a] = L(a, a);
    for (int b = a + 1; b < Dim; ++b) result[k++] = root_half * (L(a, b) + L(b, a));
  }
  return result;
}

/// Returns the identity tensor in Mandel notation.
template <int Dim, class Real>
SCREE_FN Vec<symmetric_size<Dim>, Real> symmetric_identity() {
  auto result = zero<Vec<symmetric_size<Dim>, Real>>();
  for (int a = 0; a < Dim; ++a) result[a] = 1;
  return result;
}

/// Solves A x = b for a symmetric positive definite matrix A by an LDL^T decomposition that reads only the lower
/// triangle of A; b and x are vectors or matrices of column vectors. Returns false, and leaves x unchanged, if a pivot
/// does not exceed `tolerance` times the largest diagonal entry of A.
template <int N, class Real, int Columns>
SCREE_FN bool solve_positive_definite(Mat<N, Real> A, Small<Real, N, Columns> b, Real tolerance,
                                      Small<Real, N, Columns>& x) {
  Real largest = A(0, 0);
  for (int k = 1; k < N; ++k) largest = Kokkos::max(largest, A(k, k));
  Real const least = tolerance * largest;
  Real inverse[N];  // reciprocals of the pivots
  for (int k = 0; k < N; ++k) {
    if (!(A(k, k) > least)) return false;
    inverse[k] = 1 / A(k, k);
    for (int i = k + 1; i < N; ++i) {
      Real const factor = A(i, k) * inverse[k];
      for (int j = k + 1; j <= i; ++j) A(i, j) -= factor * A(j, k);
      for (int c = 0; c < Columns; ++c) b(i, c) -= factor * b(k, c);
    }
  }
  for (int c = 0; c < Columns; ++c)
    for (int k = N - 1; k >= 0; --k) {
      b(k, c) *= inverse[k];
      for (int i = 0; i < k; ++i) b(i, c) -= A(k, i) * b(k, c);
    }
  x = b;
  return true;
}

}  // namespace scree
