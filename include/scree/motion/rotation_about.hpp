// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "motion.hpp"

namespace scree {

/// A steady rotation in 3D about any axis, by the right-hand rule, with the velocity u = Omega n x (x - c) and the
/// acceleration $\Omega^2 n \times (n \times (x - c))$. Positions follow from Rodrigues' formula.
class RotationAbout {
 public:
  struct Parameters {
    double rate = 0;                    ///< Omega, rad/s
    Vec<3, double> axis = {0, 0, 1};    ///< direction of the axis n, of any length above 0
    Vec<3, double> centre = {0, 0, 0};  ///< a point c on the axis, m
    double angle_per_step = 0.05;       ///< largest angle in one time step, rad

    static constexpr auto parameters() {
      return std::array{
          parameter("rate", &Parameters::rate, "rad/s", "angular velocity", allowed::finite()),
          parameter("axis", &Parameters::axis, "1", "direction of the axis, of any length above 0", allowed::finite()),
          parameter("centre", &Parameters::centre, "m", "a point of the axis", allowed::finite()),
          parameter("angle_per_step", &Parameters::angle_per_step, "rad", "largest angle in one step",
                    allowed::above_or_infinite(0))};
    }
    /// Throws std::invalid_argument if a parameter is out of range.
    void check() const {
      check_parameters(*this, "RotationAbout");
      check_setting(axis.norm() > 0, "length of the axis of RotationAbout", axis.norm(), "above 0");
    }
  };

  /// Makes a motion at rest.
  RotationAbout() = default;
  /// Makes a rotation with these parameters. Throws std::invalid_argument if one is out of range.
  explicit RotationAbout(Parameters const& given)
      : rate_(given.rate), angle_per_step_(given.angle_per_step), centre_(given.centre) {
    given.check();
    axis_ = given.axis / given.axis.norm();
  }
  /// Makes a rotation from rate (rad/s), axis, centre (m) and largest angle per step (rad). Throws
  /// std::invalid_argument if one is out of range.
  RotationAbout(double rate, Vec<3, double> const& axis, Vec<3, double> const& centre = Vec<3, double>::Zero(),
                double angle_per_step = 0.05)
      : RotationAbout(Parameters{rate, axis, centre, angle_per_step}) {}

  template <class X>
  SCREE_FN X displaced(X const& x, double from, double to) const {
    using Real = typename X::Scalar;
    double const angle = rate_ * (to - from);
    Real const c = Real(Kokkos::cos(angle)), s = Real(Kokkos::sin(angle));
    X const n = as<X>(axis_), arm = x - as<X>(centre_), along = n * dot(n, arm);
    return as<X>(centre_) + along + (arm - along) * c + across(n, arm) * s;
  }
  template <class X>
  SCREE_FN X velocity(X const& x, double) const {
    return across(as<X>(axis_), X(x - as<X>(centre_))) * typename X::Scalar(rate_);
  }
  template <class X>
  SCREE_FN X acceleration(X const& x, double) const {
    X const n = as<X>(axis_), arm = x - as<X>(centre_);
    return (n * dot(n, arm) - arm) * typename X::Scalar(rate_ * rate_);
  }
  double time_step() const { return angle_per_step_ / Kokkos::abs(rate_); }

 private:
  template <class X>
  SCREE_FN static X as(Vec<3, double> const& a) {
    static_assert(X::RowsAtCompileTime == 3, "RotationAbout turns points in space: in the plane use Rotation");
    X result;
    for (int k = 0; k < X::RowsAtCompileTime; ++k) result[k] = typename X::Scalar(a[k]);
    return result;
  }
  /// Returns the cross product in 3D. In 2D, as() does not compile.
  template <class X>
  SCREE_FN static X across(X const& a, X const& b) {
    if constexpr (X::RowsAtCompileTime == 3)
      return cross(a, b);
    else
      return a;
  }

  double rate_ = 0, angle_per_step_ = 0.05;
  Vec<3, double> axis_ = {0, 0, 1}, centre_ = {0, 0, 0};
};

}  // namespace scree
