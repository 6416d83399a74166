// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "types.hpp"

// Antisymmetric tensors of second order as axial vectors: W x = w x x. In 2D one number, the entry 21.
namespace scree {

/// The number of entries of an axial vector.
template <int Dim>
inline constexpr int axial_size = Dim*(Dim - 1) / 2;

/// The axial vector of M - M^T.
template <int Dim, class Real>
SCREE_FN Vec<axial_size<Dim>, Real> twice_axial(Mat<Dim, Real> const& M) {
  Vec<axial_size<Dim>, Real> a;
  if constexpr (Dim == 2) {
    a[0] = M(1, 0) - M(0, 1);
  } else {
    a[0] = M(2, 1) - M(1, 2);
    a[1] = M(0, 2) - M(2, 0);
    a[2] = M(1, 0) - M(0, 1);
  }
  return a;
}

/// The product of an axial vector in 2D with a vector. In 3D it is the cross product of vectors (core/algebra.hpp).
template <class Real>
SCREE_LOOP_FN Small<Real, 2, 1> cross(Small<Real, 1, 1> const& a, Small<Real, 2, 1> const& x) {
  return {-a[0] * x[1], a[0] * x[0]};
}

/// The antisymmetric tensor that has this axial vector.
template <int Dim, class Real>
SCREE_FN Mat<Dim, Real> antisymmetric(Vec<axial_size<Dim>, Real> const& a) {
  auto W = zero<Mat<Dim, Real>>();
  if constexpr (Dim == 2) {
    W(1, 0) = a[0];
    W(0, 1) = -a[0];
  } else {
    W(2, 1) = a[0], W(1, 2) = -a[0];
    W(0, 2) = a[1], W(2, 0) = -a[1];
    W(1, 0) = a[2], W(0, 1) = -a[2];
  }
  return W;
}

}  // namespace scree
