// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "motion.hpp"

#include <cmath>

namespace scree {

/// Steady rotation in space about any axis, by the right-hand rule: u = Omega n x (x - c), acceleration
/// Omega^2 n x (n x (x - c)). Positions follow Rodrigues' formula.
class RotationAbout {
 public:
  /// At rest.
  RotationAbout() = default;
  /// `rate` in rad/s; `axis` of any length above 0; `centre` is any point of the axis, m; `angle_per_step` is the
  /// largest angle in one step, rad. Throws std::invalid_argument if a number is out of its range.
  RotationAbout(double rate, Vec<3, double> const& axis, Vec<3, double> const& centre = Vec<3, double>::Zero(),
                double angle_per_step = 0.05)
      : rate_(rate), angle_per_step_(angle_per_step), centre_(centre) {
    check_setting(std::isfinite(rate), "rate of a rotation (rad/s)", rate, "finite");
    check_setting(axis.allFinite() && axis.norm() > 0, "length of the axis of a rotation", axis.norm(), "above 0");
    check_setting(centre.allFinite(), "centre of a rotation (m)", centre.sum(), "finite");
    check_setting(angle_per_step > 0, "angle per step of a rotation (rad)", angle_per_step, "above 0");
    axis_ = axis / axis.norm();
  }

  template <class X>
  SCREE_FN X displaced(X const& x, double from, double to) const {
    using Real = typename X::Scalar;
    double const angle = rate_ * (to - from);
    Real const c = Real(Kokkos::cos(angle)), s = Real(Kokkos::sin(angle));
    X const n = as<X>(axis_), arm = x - as<X>(centre_), along = n * dot(n, arm);
    return as<X>(centre_) + along + (arm - along) * c + cross(n, arm) * s;
  }
  template <class X>
  SCREE_FN X velocity(X const& x, double) const {
    return cross(as<X>(axis_), X(x - as<X>(centre_))) * typename X::Scalar(rate_);
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
    for (int k = 0; k < 3; ++k) result[k] = typename X::Scalar(a[k]);
    return result;
  }

  double rate_ = 0, angle_per_step_ = 0.05;
  Vec<3, double> axis_ = {0, 0, 1}, centre_ = {0, 0, 0};
};

}  // namespace scree
