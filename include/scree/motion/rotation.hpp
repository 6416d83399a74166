// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "motion.hpp"

#include <cmath>

namespace scree {

/// A steady rotation in the plane of the first and the last coordinate (x and z), from x towards z; in 3D, the rotation
/// is about the second axis. The velocity is u = Omega x (x - c), and the acceleration is $-\Omega^2 (x - c)$ within
/// the plane.
struct Rotation {
  double rate = 0;  ///< Omega, rad/s
  /// Largest angle in one time step, rad.
  double angle_per_step = 0.05;
  double centre_x = 0;  ///< m
  double centre_z = 0;  ///< m

  static constexpr auto parameters() {
    return std::array{
        parameter("rate", &Rotation::rate, "rad/s", "angular velocity", allowed::finite()),
        parameter("centre_x", &Rotation::centre_x, "m", "first coordinate of the axis", allowed::finite()),
        parameter("centre_z", &Rotation::centre_z, "m", "last coordinate of the axis", allowed::finite()),
        parameter("angle_per_step", &Rotation::angle_per_step, "rad", "largest angle in one step",
                  allowed::above_or_infinite(0))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const { check_parameters(*this, "Rotation"); }
  template <class X>
  SCREE_FN X displaced(X const& x, double from, double to) const {
    using Real = typename X::Scalar;
    double const angle = rate * (to - from);
    Real const c = Real(Kokkos::cos(angle)), s = Real(Kokkos::sin(angle));
    X const arm = arm_of(x);
    X turned = x;
    turned[0] = Real(centre_x) + c * arm[0] - s * arm[up<X>];
    turned[up<X>] = Real(centre_z) + s * arm[0] + c * arm[up<X>];
    return turned;
  }
  template <class X>
  SCREE_FN X velocity(X const& x, double) const {
    using Real = typename X::Scalar;
    X const arm = arm_of(x);
    X u = zero<X>();
    u[0] = -Real(rate) * arm[up<X>];
    u[up<X>] = Real(rate) * arm[0];
    return u;
  }
  template <class X>
  SCREE_FN X acceleration(X const& x, double) const {
    return arm_of(x) * -typename X::Scalar(rate * rate);
  }
  double time_step() const { return angle_per_step / Kokkos::abs(rate); }

 private:
  template <class X>
  static constexpr int up = X::RowsAtCompileTime - 1;
  /// Returns the vector from the axis to x, within the plane.
  template <class X>
  SCREE_FN X arm_of(X const& x) const {
    using Real = typename X::Scalar;
    X arm = zero<X>();
    arm[0] = x[0] - Real(centre_x);
    arm[up<X>] = x[up<X>] - Real(centre_z);
    return arm;
  }
};

}  // namespace scree
