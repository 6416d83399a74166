// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "fields.hpp"
#include "problem.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

// Exact solutions as functions of height: over time for the symmetric flux with constant V and D, and the steady state
// for any flux and closure.
namespace shear_box::reference {

/// The exact solution of C_t = (V C (1 - C))_z + D C_zz without flux at z = 0 and 1, with C = 0 below 1/2 and 1 above
/// at t = 0.
///
/// Cole-Hopf: C = 1/2 - (D/V) psi_z/psi gives psi_t = D psi_zz - D k^2 psi with k = V/(2D). The no-flux condition gives
/// psi_zz = k^2 psi at the ends, so psi(z, 0) = exp(k min(z, 1 - z)) keeps its end values 1, and
///   psi = cosh k(z - 1/2)/cosh(k/2) + sum_{n odd} b_n exp(-D (n^2 pi^2 + k^2) t) sin(n pi z),
///   b_n = 4 k e^{k/2} sin(n pi/2) / (k^2 + n^2 pi^2).
/// Numerator and denominator of psi_z/psi are divided by e^{k/2}, the largest value of psi, so that nothing overflows.
/// Near the ends the sum loses a factor e^{k/2} to cancellation: ten digits are left at Pe = 51, and five at Pe = 100,
/// the largest Pe accepted.
class ExactSeries {
 public:
  explicit ExactSeries(Coefficients coefficients)
      : D_(coefficients.diffusivity), k_(0.5 * coefficients.velocity / coefficients.diffusivity) {
    if (!(k_ > 0.0 && k_ <= 50.0))
      throw std::invalid_argument("shear box reference: exact series needs a Peclet number V/D in (0, 100]");
  }

  double operator()(double z, double t) const {
    if (t <= 0.0) return z < 0.5 ? 0.0 : (z > 0.5 ? 1.0 : 0.5);
    Psi const steady = steady_part(z);
    Psi const transient = transient_part(z, t);
    return 0.5 - 0.5 / k_ * (steady.slope + transient.slope) / (steady.value + transient.value);
  }

  // Returns the number of terms n = 1, 3, ... in the sum. The last term is smaller than the first by a factor exp(-45)
  // ~ 3e-20, which is below the rounding error of the sum; the decay of b_n reduces the term further. The number is
  // limited to about 100 000, reached for D t < 1.2e-10.
  int terms(double t) const {
    double const last_n = std::sqrt(45.0 / (D_ * std::max(t, 1e-300))) / std::numbers::pi;
    return 2 + static_cast<int>(std::min(0.5 * last_n, 1e5));
  }

 private:
  struct Psi {
    double value;
    double slope;
  };

  Psi steady_part(double z) const {
    double const distance = z - 0.5;
    double const near = std::exp(k_ * (distance - 1.0));
    double const far = std::exp(-k_ * (distance + 1.0));
    double const scale = 1.0 / (1.0 + std::exp(-k_));
    return {.value = scale * (near + far), .slope = scale * k_ * (near - far)};
  }

  Psi transient_part(double z, double t) const {
    Psi sum{0.0, 0.0};
    double sign = 1.0;  // sin(n pi/2)
    for (int m = 0, last = terms(t); m < last; ++m, sign = -sign) {
      double const a = (2 * m + 1) * std::numbers::pi;
      double const b = sign * 4.0 * k_ / (k_ * k_ + a * a) * std::exp(-D_ * (a * a + k_ * k_) * t);
      sum.value += b * std::sin(a * z);
      sum.slope += b * a * std::cos(a * z);
    }
    return sum;
  }

  double D_;
  double k_;
};

/// Returns the steady concentration at height z for constant V and D, the symmetric flux and a mean of 1/2.
inline double symmetric_steady_state(double peclet, double z) { return 1.0 / (1.0 + std::exp(peclet * (z - 0.5))); }

namespace detail {

/// The steady state D dC/dz = -V F. With y = ln(C/(1 - C)) this is dy/dz = -(V/D) A (1 - kappa C), where y is smooth
/// however steep C is.
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

  // Returns an upper bound of y at the bottom: the largest possible decrease of y. If the mean is 1/2, y decreases from
  // >= 0 to <= 0.
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

/// Returns the steady profile with mean 1/2, for any flux and closure (rate(t) scales both sides and cancels).
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
