// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "types.hpp"

// Antisymmetric tensors W of second order, stored as axial vectors w, so that W x is the cross product of w and x. In
// 2D, the axial vector has one entry, W_21.
namespace scree {

/// The number of entries of an axial vector.
template <int Dim>
inline constexpr int axial_size = Dim*(Dim - 1) / 2;

/// Returns the axial vector of M - M^T.
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

/// Returns the product of a 2D axial vector and a vector. In 3D, the product is the cross product of two vectors
/// (core/algebra.hpp).
template <class Real>
SCREE_LOOP_FN Small<Real, 2, 1> cross(Small<Real, 1, 1> const& a, Small<Real, 2, 1> const& x) {
  return {-a[0] * x[1], a[0] * x[0]};
}

/// Returns the antisymmetric tensor with a given axial vector.
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
