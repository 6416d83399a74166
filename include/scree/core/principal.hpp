// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "types.hpp"

namespace scree {

/// The unsorted principal values of a symmetric 3 x 3 tensor, and their directions as the columns of a rotation matrix.
template <class Real>
struct Principal {
  Vec<3, Real> values;
  Mat<3, Real> axes;
};

namespace detail {
// Applies one Jacobi rotation, which makes A(p, q) zero.
template <class Real>
SCREE_FN void rotate_away(Mat<3, Real>& A, Mat<3, Real>& axes, int p, int q) {
  if (A(p, q) == 0) return;
  Real const theta = (A(q, q) - A(p, p)) / (2 * A(p, q));
  Real const t = (theta < 0 ? Real(-1) : Real(1)) / (Kokkos::abs(theta) + Kokkos::sqrt(theta * theta + 1));
  Real const c = 1 / Kokkos::sqrt(t * t + 1), s = t * c;
  for (int k = 0; k < 3; ++k) {
    Real const kp = A(k, p), kq = A(k, q);
    A(k, p) = c * kp - s * kq;
    A(k, q) = s * kp + c * kq;
  }
  for (int k = 0; k < 3; ++k) {
    Real const pk = A(p, k), qk = A(q, k), ap = axes(k, p), aq = axes(k, q);
    A(p, k) = c * pk - s * qk;
    A(q, k) = s * pk + c * qk;
    axes(k, p) = c * ap - s * aq;
    axes(k, q) = s * ap + c * aq;
  }
}
}  // namespace detail

/// Returns the principal values and directions of a tensor, found by Jacobi's method, which stays accurate if values
/// coincide. Convergence is quadratic: five sweeps reach double precision, and one sweep is enough for a tensor that
/// does not couple the plane of the first two axes to the third axis.
template <class Real>
SCREE_FN Principal<Real> principal(Mat<3, Real> A) {
  auto axes = identity_matrix<Mat<3, Real>>();
  for (int sweep = 0; sweep < 5; ++sweep) {
    detail::rotate_away(A, axes, 0, 1);
    detail::rotate_away(A, axes, 0, 2);
    detail::rotate_away(A, axes, 1, 2);
  }
  return {Vec<3, Real>(A(0, 0), A(1, 1), A(2, 2)), axes};
}

/// Returns the part of a symmetric tensor with positive principal values; for a stress, this part is the tension.
template <class Real>
SCREE_FN Mat<3, Real> positive_part(Mat<3, Real> const& A) {
  Principal<Real> const p = principal(A);
  auto result = zero<Mat<3, Real>>();
  for (int k = 0; k < 3; ++k) {
    Vec<3, Real> const axis(p.axes(0, k), p.axes(1, k), p.axes(2, k));
    if (p.values[k] > 0) result += outer(p.values[k] * axis, axis);
  }
  return result;
}

}  // namespace scree
