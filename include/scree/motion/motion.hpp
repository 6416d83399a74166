// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"
#include "../fields/list.hpp"
#include "../fields/standard.hpp"

#include <type_traits>

namespace scree {

/// Whether M is a motion of all points, as a value with
///   displaced(x, from, to)   the position at time `to` (s) of the point that is at x (m) at time `from` (s), m
///   velocity(x, time)        the velocity of the point that is at x (m) at a time (s), m/s
///   acceleration(x, time)    the acceleration of the point that is at x (m) at a time (s), m/s^2
///   time_step()              the largest time step that resolves the motion, s
/// and, if its velocity is not affine in x,
///   velocity_gradient(x, time)   the velocity gradient L_ab = du_a/dx_b at x and a time (s), 1/s
/// Walls need the gradient to evaluate the motion at points other than their particles. Without this function, the
/// gradient is a difference over one metre, and a solver rejects walls with a velocity that is not affine. A motion
/// that is limited to one number of dimensions declares it as a constant `dim`.
template <class M, int Dim, class Real>
concept MotionOfPoints = requires(M const& motion, Vec<Dim, Real> const& x, double time) {
  Vec<Dim, Real>(motion.displaced(x, time, time));
  Vec<Dim, Real>(motion.velocity(x, time));
  Vec<Dim, Real>(motion.acceleration(x, time));
  { motion.time_step() } -> std::convertible_to<double>;
};

/// Whether M is a motion that differs between the groups of a body, as a value with
///   of(group)     the motion of the points of one group, 0 <= group < groups()
///   groups()      the number of groups
///   time_step()   the largest time step that resolves the motions of all groups, s
/// Particles that follow such a motion carry the field `group`. The velocity must be affine in x within each group.
template <class M>
concept MotionByGroup = requires(M const& motion, int number) {
  motion.of(number);
  { motion.groups() } -> std::convertible_to<int>;
  { motion.time_step() } -> std::convertible_to<double>;
};

namespace detail {
template <class M, int Dim, class Real>
inline constexpr bool moves_each_group = false;
template <MotionByGroup M, int Dim, class Real>
inline constexpr bool moves_each_group<M, Dim, Real> =
    MotionOfPoints<std::remove_cvref_t<decltype(std::declval<M const&>().of(0))>, Dim, Real>;
}  // namespace detail

/// Whether M is a prescribed motion, either of all points or by group.
template <class M, int Dim, class Real>
concept PrescribedMotion = MotionOfPoints<M, Dim, Real> || detail::moves_each_group<M, Dim, Real>;

/// Whether a motion has a function for its velocity gradient (1/s) at a point and a time (s).
template <class M, int Dim, class Real>
concept GivesVelocityGradient = requires(M const& motion, Vec<Dim, Real> const& x, double time) {
  Mat<Dim, Real>(motion.velocity_gradient(x, time));
};

/// The fields of a particle that determine which motion it follows.
template <class M>
using fields_of_motion = std::conditional_t<MotionByGroup<M>, Fields<Group>, Fields<>>;

/// Returns the motion of a group, from a motion by group or from a motion of all points.
template <class M>
SCREE_FN decltype(auto) motion_of_group(M const& motion, [[maybe_unused]] int number) {
  if constexpr (MotionByGroup<M>)
    return motion.of(number);
  else
    return (motion);
}
/// Returns the motion of a particle, from a motion by group or from a motion of all points.
template <class M, class I>
SCREE_FN decltype(auto) motion_of(M const& motion, [[maybe_unused]] I const& i) {
  if constexpr (MotionByGroup<M>)
    return motion.of(i[fields::group]);
  else
    return (motion);
}

/// Returns the velocity gradient of a motion of points, or the difference over one metre, which is exact for affine
/// motions, 1/s.
template <class M, class X>
SCREE_FN auto velocity_gradient_at(M const& motion, X const& x, double time) {
  using Real = typename X::Scalar;
  constexpr int dim = X::RowsAtCompileTime;
  Mat<dim, Real> L;
  if constexpr (GivesVelocityGradient<M, dim, Real>) {
    L = motion.velocity_gradient(x, time);
  } else {
    for (int axis = 0; axis < dim; ++axis) {
      X there = x;
      there[axis] += 1;
      L.col(axis) = motion.velocity(there, time) - motion.velocity(x, time);
    }
  }
  return L;
}

/// The motion of points at rest.
struct AtRest {
  template <class X>
  SCREE_FN X displaced(X const& x, double, double) const {
    return x;
  }
  template <class X>
  SCREE_FN X velocity(X const&, double) const {
    return zero<X>();
  }
  template <class X>
  SCREE_FN X acceleration(X const&, double) const {
    return zero<X>();
  }
  double time_step() const { return Kokkos::Experimental::infinity_v<double>; }
};

}  // namespace scree
