// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "element.hpp"

#include <scree/laws/hypoplastic.hpp>

#include <numbers>

// A hypoplastic sand and one point of it, without particles.
namespace scree::test {

/// Sand of Hochstetten, parameters as used by Niemunis & Herle (1997).
inline Hypoplastic hochstetten() {
  return {.critical_angle = 33 * std::numbers::pi / 180,
          .granulate_hardness = 1e9,
          .exponent = 0.25,
          .e_d0 = 0.55,
          .e_c0 = 0.95,
          .e_i0 = 1.05,
          .alpha = 0.25,
          .beta = 1,
          .rest_density = 1600};
}

/// The void ratio alone, as a point and as the rate of it.
struct OfVoids {
  double value = 0;
  double operator[](VoidRatio) const { return value; }
  double& operator[](VoidRatioRate) { return value; }
};

/// A point of a law with a void ratio, by Runge-Kutta steps of fourth order. The second axis is the axial one.
template <class Law = Hypoplastic>
struct Sand {
  using Tensor = StressTensor<double>;
  Law law;
  Tensor sigma = Tensor::Zero();
  double e = 0;

  double p() const { return pressure_of(sigma); }
  /// The angle mobilised by the axial and the lateral stress, rad.
  double friction_angle() const { return std::asin((sigma(1, 1) - sigma(0, 0)) / (sigma(1, 1) + sigma(0, 0))); }
  /// `gradient` is a function of this point.
  template <class GradientOf>
  void follow(GradientOf const& gradient, double duration, int steps) {
    double const dt = duration / steps;
    for (int n = 0; n < steps; ++n) {
      Sand const k1 = rates(gradient), k2 = moved(k1, dt / 2).rates(gradient), k3 = moved(k2, dt / 2).rates(gradient),
                 k4 = moved(k3, dt).rates(gradient);
      *this = moved(k1, dt / 6).moved(k2, dt / 3).moved(k3, dt / 3).moved(k4, dt / 6);
    }
  }
  Tensor stress_rate(Tensor const& L) const { return law.stress_rate(sigma, L, OfVoids{e}); }

 private:
  Sand moved(Sand const& rate, double dt) const { return {law, sigma + dt * rate.sigma, e + dt * rate.e}; }
  template <class GradientOf>
  Sand rates(GradientOf const& gradient) const {
    Tensor const L = gradient(*this);
    OfVoids change;
    law.history_rate(sigma, L, OfVoids{e}, change);
    return {law, stress_rate(L), change.value};
  }
};

/// Axial compression with the strain rate 1 and given lateral rate of extension.
inline Mat<3, double> compression(double lateral) { return Vec<3, double>(lateral, -1, lateral).asDiagonal(); }
inline auto oedometer = [](auto const&) { return compression(0); };
inline auto isotropic = [](auto const&) { return compression(-1); };
/// Lateral extension that keeps the lateral stress, by bisection.
inline auto drained = [](auto const& sand) {
  double low = -1, high = 2;
  for (int n = 0; n < 60; ++n) {
    double const middle = (low + high) / 2;
    (sand.stress_rate(compression(middle))(0, 0) < 0 ? low : high) = middle;
  }
  return compression((low + high) / 2);
};
inline auto sheared = [](auto const&) {
  Mat<3, double> L = Mat<3, double>::Zero();
  L(0, 1) = 1;
  return L;
};

}  // namespace scree::test
