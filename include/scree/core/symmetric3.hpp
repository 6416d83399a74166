// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "types.hpp"

// Symmetric 3 x 3 tensors, stored as vectors of their entries. In 2D, the entries are 11, 22, 33 and 12, where 3 is the
// direction out of the plane (plane strain); entries 13 and 23 are zero. In 3D, the entries are 11, 22, 33, 12, 13 and
// 23.
namespace scree {

/// The number of stored entries of a symmetric 3 x 3 tensor: 4 in plane strain, 6 in 3D.
template <int Dim>
inline constexpr int symmetric3_size = Dim == 2 ? 4 : 6;

/// Returns the full 3 x 3 tensor with the given entries.
template <class Packed>
SCREE_FN Mat<3, typename Packed::Scalar> unpacked(Packed const& s) {
  auto full = zero<Mat<3, typename Packed::Scalar>>();
  for (int a = 0; a < 3; ++a) full(a, a) = s[a];
  full(0, 1) = full(1, 0) = s[3];
  if constexpr (Packed::RowsAtCompileTime == 6) {
    full(0, 2) = full(2, 0) = s[4];
    full(1, 2) = full(2, 1) = s[5];
  }
  return full;
}

/// Returns the stored entries of a symmetric 3 x 3 tensor, reading only its upper triangle.
template <int Dim, class Real>
SCREE_FN Vec<symmetric3_size<Dim>, Real> packed(Mat<3, Real> const& full) {
  Vec<symmetric3_size<Dim>, Real> s;
  for (int a = 0; a < 3; ++a) s[a] = full(a, a);
  s[3] = full(0, 1);
  if constexpr (Dim == 3) {
    s[4] = full(0, 2);
    s[5] = full(1, 2);
  }
  return s;
}

/// Returns the product of a symmetric 3 x 3 tensor and a vector with two or three components.
template <class Packed, class X>
SCREE_FN X product(Packed const& s, X const& x) {
  X y;
  if constexpr (X::RowsAtCompileTime == 2) {
    y[0] = s[0] * x[0] + s[3] * x[1];
    y[1] = s[3] * x[0] + s[1] * x[1];
  } else {
    y[0] = s[0] * x[0] + s[3] * x[1] + s[4] * x[2];
    y[1] = s[3] * x[0] + s[1] * x[1] + s[5] * x[2];
    y[2] = s[4] * x[0] + s[5] * x[1] + s[2] * x[2];
  }
  return y;
}

/// Returns a velocity gradient as a 3 x 3 tensor, which in 2D is zero out of the plane.
template <int Dim, class Real>
SCREE_FN Mat<3, Real> in_three_dimensions(Mat<Dim, Real> const& L) {
  auto full = zero<Mat<3, Real>>();
  for (int a = 0; a < Dim; ++a)
    for (int b = 0; b < Dim; ++b) full(a, b) = L(a, b);
  return full;
}

}  // namespace scree
