// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"

// Rotations of rigid bodies, in double precision. In 2D an angular velocity or a moment is one number, positive from
// the first axis towards the last, and an attitude is an angle. In 3D an angular velocity or a moment is a vector in
// the axes of space, by the right-hand rule, and an attitude is a unit quaternion with the scalar part first.
namespace scree {

/// The number of components of an angular velocity: 1 in 2D, 3 in 3D.
template <int Dim>
inline constexpr int turns_in = Dim == 2 ? 1 : 3;
/// An angular velocity (rad/s), an angular momentum (kg m^2/s) or a moment (N m).
template <int Dim>
using Turn = Vec<turns_in<Dim>, double>;
/// The rotation of a body since time zero: an angle (rad) or a unit quaternion.
template <int Dim>
using Attitude = Vec<(Dim == 2 ? 1 : 4), double>;
/// A moment of inertia (2D) or a tensor of inertia (3D), kg m^2.
template <int Dim>
using Inertia = Mat<turns_in<Dim>, double>;

/// Returns w x r, the velocity of a point at the arm r. The 3D version is the cross product in core/algebra.hpp.
SCREE_FN Vec<2, double> cross(Turn<2> const& w, Vec<2, double> const& r) { return {-w[0] * r[1], w[0] * r[0]}; }
/// Returns r x F, the moment of a force F with the arm r.
SCREE_FN Turn<2> moment_of(Vec<2, double> const& r, Vec<2, double> const& F) {
  return Turn<2>::Constant(r[0] * F[1] - r[1] * F[0]);
}
SCREE_FN Turn<3> moment_of(Vec<3, double> const& r, Vec<3, double> const& F) { return cross(r, F); }

/// Returns the matrix W with W r = w x r.
SCREE_FN Mat<2, double> cross_matrix(Turn<2> const& w) {
  Mat<2, double> W = zero<Mat<2, double>>();
  W(0, 1) = -w[0], W(1, 0) = w[0];
  return W;
}
SCREE_FN Mat<3, double> cross_matrix(Turn<3> const& w) {
  Mat<3, double> W = zero<Mat<3, double>>();
  W(0, 1) = -w[2], W(0, 2) = w[1], W(1, 2) = -w[0];
  W(1, 0) = w[2], W(2, 0) = -w[1], W(2, 1) = w[0];
  return W;
}

/// Returns the attitude at time zero.
template <int Dim>
SCREE_FN Attitude<Dim> upright() {
  Attitude<Dim> q = zero<Attitude<Dim>>();
  if (Dim == 3) q[0] = 1;
  return q;
}

/// Returns the attitude q after a further rotation by the vector w (rad).
SCREE_FN Attitude<2> turned(Attitude<2> const& q, Turn<2> const& w) { return q + w; }
SCREE_FN Attitude<3> turned(Attitude<3> const& q, Turn<3> const& w) {
  double const half = norm(w) / 2, c = Kokkos::cos(half);
  double const s = half > 1e-6 ? Kokkos::sin(half) / (2 * half) : 0.5 * (1 - half * half / 6);
  Vec<3, double> const v = s * w;
  Attitude<3> r;
  r[0] = c * q[0] - (v[0] * q[1] + v[1] * q[2] + v[2] * q[3]);
  r[1] = c * q[1] + v[0] * q[0] + v[1] * q[3] - v[2] * q[2];
  r[2] = c * q[2] + v[1] * q[0] + v[2] * q[1] - v[0] * q[3];
  r[3] = c * q[3] + v[2] * q[0] + v[0] * q[2] - v[1] * q[1];
  return r / norm(r);
}

/// Returns the rotation matrix of an attitude, which maps the axes of the body to the axes of space. At time zero the
/// axes of the body are the axes of space.
SCREE_FN Mat<2, double> matrix_of(Attitude<2> const& q) {
  double const c = Kokkos::cos(q[0]), s = Kokkos::sin(q[0]);
  Mat<2, double> R;
  R(0, 0) = R(1, 1) = c, R(1, 0) = s, R(0, 1) = -s;
  return R;
}
SCREE_FN Mat<3, double> matrix_of(Attitude<3> const& q) {
  Mat<3, double> R;
  for (int a = 0; a < 3; ++a) {
    int const b = (a + 1) % 3, c = (a + 2) % 3;
    R(a, a) = 1 - 2 * (q[1 + b] * q[1 + b] + q[1 + c] * q[1 + c]);
    R(a, b) = 2 * (q[1 + a] * q[1 + b] - q[0] * q[1 + c]);
    R(b, a) = 2 * (q[1 + a] * q[1 + b] + q[0] * q[1 + c]);
  }
  return R;
}

/// Returns the inertia of a body in the axes of space.
SCREE_FN Inertia<2> in_space(Inertia<2> const& of_body, Attitude<2> const&) { return of_body; }
SCREE_FN Inertia<3> in_space(Inertia<3> const& of_body, Attitude<3> const& q) {
  Mat<3, double> const R = matrix_of(q);
  return R * of_body * transposed(R);
}

/// Returns the solution x of A x = b.
SCREE_FN Turn<2> solved(Inertia<2> const& A, Turn<2> const& b) { return Turn<2>::Constant(b[0] / A(0, 0)); }
SCREE_FN Turn<3> solved(Inertia<3> const& A, Turn<3> const& b) {
  auto const row = [&](int a) { return Vec<3, double>(A(a, 0), A(a, 1), A(a, 2)); };
  Vec<3, double> const r0 = row(0), r1 = row(1), r2 = row(2);
  Vec<3, double> const c0 = cross(r1, r2), c1 = cross(r2, r0), c2 = cross(r0, r1);
  return (b[0] * c0 + b[1] * c1 + b[2] * c2) / dot(r0, c0);
}

}  // namespace scree
