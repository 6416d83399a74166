// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"

namespace scree {

/// A prescribed motion, as a value:
///   displaced(x, from, to)   where the point that is at x at time `from` (s) is at time `to`
///   velocity(x, time)        its velocity, m/s
///   acceleration(x, time)    its acceleration, m/s^2
///   time_step()              largest step that resolves the motion, s
/// and, if its velocity is not affine in x,
///   velocity_gradient(x, time)   L_ab = du_a/dx_b, 1/s
/// Walls need the gradient for the velocity that they show the material behind their surface. Without this function it
/// is the difference over one metre, and a solver rejects walls whose velocity is not affine.
template <class M, int Dim, class Real>
concept PrescribedMotion = requires(M const& motion, Vec<Dim, Real> const& x, double time) {
  Vec<Dim, Real>(motion.displaced(x, time, time));
  Vec<Dim, Real>(motion.velocity(x, time));
  Vec<Dim, Real>(motion.acceleration(x, time));
  { motion.time_step() } -> std::convertible_to<double>;
};

template <class M, int Dim, class Real>
concept GivesVelocityGradient = requires(M const& motion, Vec<Dim, Real> const& x, double time) {
  Mat<Dim, Real>(motion.velocity_gradient(x, time));
};

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
