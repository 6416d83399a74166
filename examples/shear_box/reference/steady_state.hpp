// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "closure.hpp"
#include "profile.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace shear_box::reference {

/// Constant V and D, symmetric flux, mean 1/2.
inline double symmetric_steady_state(double peclet, double z) { return 1.0 / (1.0 + std::exp(peclet * (z - 0.5))); }

namespace detail {

/// D dC/dz = -V F. With y = ln(C/(1 - C)):  dy/dz = -(V/D) A (1 - kappa C), smooth for any steepness of C.
template <class Closure>
class SteadyColumn {
 public:
  SteadyColumn(Problem<Closure> const& problem, int cells) : problem_(problem), cells_(cells) {}

  double slope(double y) const {
    double const C = concentration(y);
    return -problem_.closure.velocity(C) / problem_.closure.diffusivity(C) * problem_.flux.amplitude *
           (1.0 - problem_.flux.kappa * C);
  }

  Profile profile(double y_bottom) const {
    Profile result{.h = 1.0 / cells_, .values = {}};
    double y = runge_kutta_4(y_bottom, 0.5 * result.h);
    for (int i = 0; i < cells_; ++i, y = runge_kutta_4(y, result.h)) result.values.push_back(concentration(y));
    return result;
  }

  // y falls from >= 0 to <= 0 if the mean is 1/2, so y at the bottom is at most its largest possible fall.
  double largest_fall() const {
    double fall = 0.0;
    for (int i = 0; i <= 100; ++i)
      fall = std::max(fall, problem_.closure.velocity(0.01 * i) / problem_.closure.diffusivity(0.01 * i));
    return problem_.flux.amplitude * fall;
  }

 private:
  static double concentration(double y) { return 1.0 / (1.0 + std::exp(-y)); }

  double runge_kutta_4(double y, double dz) const {
    double const k1 = slope(y);
    double const k2 = slope(y + 0.5 * dz * k1);
    double const k3 = slope(y + 0.5 * dz * k2);
    double const k4 = slope(y + dz * k3);
    return y + dz / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }

  Problem<Closure> problem_;
  int cells_;
};

}  // namespace detail

/// The profile with mean 1/2 that no longer changes, for any flux and closure (rate(t) scales both sides and drops
/// out).
template <class Closure>
Profile steady_state(Problem<Closure> const& problem, int cells = 2000) {
  detail::SteadyColumn<Closure> const column(problem, cells);
  double low = 0.0, high = column.largest_fall();
  for (int bisection = 0; bisection < 60; ++bisection) {
    double const middle = 0.5 * (low + high);
    (column.profile(middle).mean() < 0.5 ? low : high) = middle;
  }
  return column.profile(0.5 * (low + high));
}

}  // namespace shear_box::reference
