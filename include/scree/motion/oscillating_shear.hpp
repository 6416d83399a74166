// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "motion.hpp"

namespace scree {

/// Simple shear of a box whose side walls tilt back and forth together: x = X + (z - floor) gamma(t) with gamma =
/// amplitude sin(2 pi t/period) and the last coordinate z (Zhu et al. 2024, section 5).
struct OscillatingShear {
  double amplitude = 0;
  double period = 1;
  double floor = 0;
  double strain_per_step = 0.05;

  static constexpr auto parameters() {
    return std::array{
        parameter("amplitude", &OscillatingShear::amplitude, "1", "tangent of the largest inclination",
                  allowed::finite()),
        parameter("period", &OscillatingShear::period, "s", "period of the walls", allowed::above(0)),
        parameter("floor", &OscillatingShear::floor, "m", "height of the points that stay at rest", allowed::finite()),
        parameter("strain_per_step", &OscillatingShear::strain_per_step, "1", "largest shear strain in one step",
                  allowed::above_or_infinite(0))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const { check_parameters(*this, "OscillatingShear"); }
  /// Returns the tangent of the inclination at a time (s).
  SCREE_FN double shear(double time) const { return amplitude * Kokkos::sin(omega() * time); }
  /// Returns the rate of the tangent of the inclination at a time (s), 1/s.
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
