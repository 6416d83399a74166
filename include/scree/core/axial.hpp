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

/// The product with a vector of the space of the antisymmetric tensor that has this axial vector.
template <class Axial, class X>
SCREE_FN X cross(Axial const& a, X const& x) {
  X y;
  if constexpr (X::RowsAtCompileTime == 2) {
    y[0] = -a[0] * x[1];
    y[1] = a[0] * x[0];
  } else {
    y[0] = a[1] * x[2] - a[2] * x[1];
    y[1] = a[2] * x[0] - a[0] * x[2];
    y[2] = a[0] * x[1] - a[1] * x[0];
  }
  return y;
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
