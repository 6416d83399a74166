// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "motion.hpp"

#include <cmath>

namespace scree {

/// Simple shear of a box whose side walls tilt back and forth together: x = X + (z - floor) gamma(t), gamma = amplitude
/// sin(2 pi t/period) (Zhu et al. 2024, section 5). z is the last coordinate.
struct OscillatingShear {
  double amplitude = 0;  ///< tangent of the largest inclination, -
  double period = 1;     ///< above 0, s
  double floor = 0;      ///< height of the points that stay at rest, m
  /// Largest increment of shear in one step, -.
  double strain_per_step = 0.05;

  /// Throws std::invalid_argument where a parameter is out of range.
  void check() const {
    check_setting(std::isfinite(amplitude), "amplitude (-) of OscillatingShear", amplitude, "finite");
    check_setting(period > 0 && std::isfinite(period), "period (s) of OscillatingShear", period, "above 0");
    check_setting(std::isfinite(floor), "floor (m) of OscillatingShear", floor, "finite");
    check_setting(strain_per_step > 0, "strain_per_step (-) of OscillatingShear", strain_per_step, "above 0");
  }
  SCREE_FN double shear(double time) const { return amplitude * Kokkos::sin(omega() * time); }
  SCREE_FN double shear_rate(double time) const { return amplitude * omega() * Kokkos::cos(omega() * time); }

  template <class X>
  SCREE_FN X displaced(X x, double from, double to) const {
    using Real = typename X::Scalar;
    x[0] += (x[x.size() - 1] - Real(floor)) * Real(shear(to) - shear(from));
    return x;
  }
  template <class X>
  SCREE_FN X velocity(X const& x, double time) const {
    using Real = typename X::Scalar;
    X u = zero<X>();
    u[0] = (x[x.size() - 1] - Real(floor)) * Real(shear_rate(time));
    return u;
  }
  template <class X>
  SCREE_FN X acceleration(X const& x, double time) const {
    using Real = typename X::Scalar;
    X a = zero<X>();
    a[0] = -(x[x.size() - 1] - Real(floor)) * Real(sq(omega()) * shear(time));
    return a;
  }
  double time_step() const { return strain_per_step / Kokkos::abs(amplitude * omega()); }

 private:
  SCREE_FN double omega() const { return 6.28318530717958648 / period; }
};

}  // namespace scree
