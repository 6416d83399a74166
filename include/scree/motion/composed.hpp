// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "motion.hpp"

namespace scree {

/// A motion within a moving frame. A point at X at time zero is at O_t(I_t(X)) at time t, with the displacements I_t
/// and O_t of the inner and the outer motion from time zero to t. The inner motion is described as if the frame stayed
/// at its position at time zero. An example is a planetary mixer, whose blade turns about an axis that itself moves in
/// a circle:
///
///     Composed<RotationAbout, RotationAbout>{.outer = {1, {0, 0, 1}}, .inner = {5, {0, 0, 1}, {0.1, 0, 0}}}
///
/// Let y be the point in the frame, w its velocity there and F the gradient of O_t. The velocity is then u_O + F w, and
/// the acceleration is a_O + 2 L_O F w + F a_I. Both motions must have velocities that are affine in x, for which
/// differences over any distance are exact derivatives. Compositions can be nested.
template <class Outer, class Inner>
struct Composed {
  Outer outer = {};  ///< the motion of the frame
  Inner inner = {};  ///< the motion within the frame

  /// Throws std::invalid_argument if a parameter of one of the two motions is out of range.
  void check() const {
    check_settings_of(outer);
    check_settings_of(inner);
  }
  template <class X>
  SCREE_FN X displaced(X const& x, double from, double to) const {
    check_affine<X>();
    return outer.displaced(X(inner.displaced(in_frame(x, from), from, to)), 0.0, to);
  }
  template <class X>
  SCREE_FN X velocity(X const& x, double time) const {
    X const y = in_frame(x, time);
    return X(outer.velocity(x, time)) + carried(y, X(inner.velocity(y, time)), x, time);
  }
  template <class X>
  SCREE_FN X acceleration(X const& x, double time) const {
    X const y = in_frame(x, time);
    X const relative = carried(y, X(inner.velocity(y, time)), x, time);
    X const turning = X(outer.velocity(X(x + relative), time)) - X(outer.velocity(x, time));
    return X(outer.acceleration(x, time)) + turning + turning + carried(y, X(inner.acceleration(y, time)), x, time);
  }
  double time_step() const { return Kokkos::min(double(outer.time_step()), double(inner.time_step())); }

 private:
  template <class X>
  SCREE_FN static constexpr void check_affine() {
    using Real = typename X::Scalar;
    constexpr int dim = X::RowsAtCompileTime;
    static_assert(
        !GivesVelocityGradient<Outer, dim, Real> && !GivesVelocityGradient<Inner, dim, Real>,
        "Composed joins motions whose velocity is affine in x: one of these has a velocity gradient of its own");
  }
  /// Returns the position in the frame of the point that is at x at a time (s).
  template <class X>
  SCREE_FN X in_frame(X const& x, double time) const {
    return outer.displaced(x, time, 0.0);
  }
  /// Transforms a vector at y from the moving frame to the fixed frame, in which y is at x.
  template <class X>
  SCREE_FN X carried(X const& y, X const& vector, X const& x, double time) const {
    return X(outer.displaced(X(y + vector), 0.0, time)) - x;
  }
};

}  // namespace scree
