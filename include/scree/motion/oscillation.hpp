// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "motion.hpp"

namespace scree {

/// The oscillation of all points along a straight line, with the displacement amplitude sin(2 pi t/period + phase).
template <int Dim>
struct Oscillation {
  static constexpr int dim = Dim;
  Vec<Dim, double> amplitude = Vec<Dim, double>::Zero();  ///< largest displacement, with its direction, m
  double period = 1;                                      ///< above 0, s
  double phase = 0;                                       ///< rad; pi/2 starts at the turning point, at rest
  /// Largest change of the phase angle in one time step, rad.
  double angle_per_step = 0.05;

  static constexpr auto parameters() {
    return std::array{parameter("amplitude", &Oscillation::amplitude, "m", "largest displacement, with its direction",
                                allowed::finite()),
                      parameter("period", &Oscillation::period, "s", "period", allowed::above(0)),
                      parameter("phase", &Oscillation::phase, "rad",
                                "phase at time zero; pi/2: at rest at the turning point", allowed::finite()),
                      parameter("angle_per_step", &Oscillation::angle_per_step, "rad", "largest angle in one step",
                                allowed::above_or_infinite(0))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const { check_parameters(*this, "Oscillation"); }
  template <class X>
  SCREE_FN X displaced(X const& x, double from, double to) const {
    return x + along<X>(Kokkos::sin(angle(to)) - Kokkos::sin(angle(from)));
  }
  template <class X>
  SCREE_FN X velocity(X const&, double time) const {
    return along<X>(omega() * Kokkos::cos(angle(time)));
  }
  template <class X>
  SCREE_FN X acceleration(X const&, double time) const {
    return along<X>(-sq(omega()) * Kokkos::sin(angle(time)));
  }
  double time_step() const {
    return amplitude.norm() > 0 ? angle_per_step / omega() : Kokkos::Experimental::infinity_v<double>;
  }

 private:
  SCREE_FN double omega() const { return 6.28318530717958648 / period; }
  SCREE_FN double angle(double time) const { return omega() * time + phase; }
  template <class X>
  SCREE_FN X along(double factor) const {
    return (amplitude * factor).template cast<typename X::Scalar>();
  }
};

}  // namespace scree
