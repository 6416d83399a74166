// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"
#include "../fields/list.hpp"
#include "../fields/standard.hpp"

#include <type_traits>

namespace scree {

/// A motion of all points, as a value:
///   displaced(x, from, to)   where the point that is at x at time `from` (s) is at time `to`, m
///   velocity(x, time)        the velocity of the point that is at x (m) at a time (s), m/s
///   acceleration(x, time)    the acceleration of that point, m/s^2
///   time_step()              the largest step that resolves the motion, s
/// and, if its velocity is not affine in x,
///   velocity_gradient(x, time)   the velocity gradient L_ab = du_a/dx_b at x and a time (s), 1/s
/// Walls need the gradient for the velocity that they show the material behind their surface. Without this function it
/// is the difference over one metre, and a solver rejects walls whose velocity is not affine.
/// A motion of points of one dimension alone has that as a constant `dim`.
template <class M, int Dim, class Real>
concept MotionOfPoints = requires(M const& motion, Vec<Dim, Real> const& x, double time) {
  Vec<Dim, Real>(motion.displaced(x, time, time));
  Vec<Dim, Real>(motion.velocity(x, time));
  Vec<Dim, Real>(motion.acceleration(x, time));
  { motion.time_step() } -> std::convertible_to<double>;
};

/// A motion that differs between the groups of a body, as a value:
///   of(group)     the motion of the points of one group, 0 <= group < groups()
///   groups()      the number of groups
///   time_step()   the largest step that resolves all of them, s
/// Particles then carry the field `group`; the velocity must be affine in x within each group.
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

/// A prescribed motion, of all points or by group.
template <class M, int Dim, class Real>
concept PrescribedMotion = MotionOfPoints<M, Dim, Real> || detail::moves_each_group<M, Dim, Real>;

/// A motion that gives its velocity gradient (1/s) at a point and a time (s).
template <class M, int Dim, class Real>
concept GivesVelocityGradient = requires(M const& motion, Vec<Dim, Real> const& x, double time) {
  Mat<Dim, Real>(motion.velocity_gradient(x, time));
};

/// Fields of a particle that decide how it moves.
template <class M>
using fields_of_motion = std::conditional_t<MotionByGroup<M>, Fields<Group>, Fields<>>;

/// The motion of a group, from a motion by group or from one for all.
template <class M>
SCREE_FN decltype(auto) motion_of_group(M const& motion, [[maybe_unused]] int number) {
  if constexpr (MotionByGroup<M>)
    return motion.of(number);
  else
    return (motion);
}
/// The motion of a particle, from a motion by group or from one for all.
template <class M, class I>
SCREE_FN decltype(auto) motion_of(M const& motion, [[maybe_unused]] I const& i) {
  if constexpr (MotionByGroup<M>)
    return motion.of(i[fields::group]);
  else
    return (motion);
}

/// The gradient of the velocity of a motion of points, or the difference over one metre, which is exact for affine
/// motions; 1/s.
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

/// No motion.
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
