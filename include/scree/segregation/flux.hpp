// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/pack.hpp"
#include "../core/root.hpp"
#include "../core/setting.hpp"

namespace scree {

/// Segregation function F(C) = A C (1 - C)(1 - kappa C): Gajjar & Gray (2014); Zhu et al. (2024), eqs 2.8 and 2.9.
struct SegregationFlux {
  double amplitude = 1;  ///< A
  double asymmetry = 0;  ///< kappa

  /// F = C (1 - C).
  static constexpr SegregationFlux symmetric() { return {}; }
  /// Small grains percolate faster than large ones rise; A as printed (equal largest flux would need 1.596).
  static constexpr SegregationFlux asymmetric() { return {.amplitude = 1.6, .asymmetry = 0.89}; }

  static constexpr auto parameters() {
    return std::array{parameter("amplitude", &SegregationFlux::amplitude, "1", "A of F = A C (1 - C)(1 - kappa C)",
                                allowed::between(0, 1e9)),
                      parameter("asymmetry", &SegregationFlux::asymmetry, "1", "kappa of F, towards fast small grains",
                                allowed::from_to(0, 1))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const { check_parameters(*this, "the segregation flux"); }
  /// F(C).
  template <class Real>
  SCREE_FN Real value(Real C) const {
    return Real(amplitude) * C * (1 - C) * (1 - Real(asymmetry) * C);
  }
  /// dF/dC at a concentration C.
  template <class Real>
  SCREE_FN Real slope(Real C) const {
    Real const kappa = Real(asymmetry);
    return Real(amplitude) * ((3 * kappa * C - 2 * (1 + kappa)) * C + 1);
  }
  /// F between a particle that gives small grains and one that takes them, without diffusion: in a shock, where the
  /// giver has fewer, the smaller of both values of F; in a fan F at the mean concentration.
  template <class Real>
  SCREE_FN Real sharp(Real giver, Real taker) const {
    using namespace math;
    return select(giver < taker, min(value(giver), value(taker)), value((giver + taker) / 2));
  }
  /// theta(C) = int dC/F = (ln C - ln(1 - C) + kappa ln(1 + (1 - kappa) x)/(1 - kappa))/A with x = C/(1 - C), the last
  /// term kappa x for kappa = 1. Minus infinity at C = 0 and below, infinity at C = 1 and above.
  template <class Real>
  SCREE_FN Real potential(Real of) const {
    Real const C = Kokkos::clamp(of, Real(0), Real(1)), kappa = Real(asymmetry), room = 1 - kappa;
    Real theta = Kokkos::log(C) - Kokkos::log(1 - C);
    if (kappa > 0) {
      Real const x = C / (1 - C);
      theta += kappa * (room > 0 ? Kokkos::log1p(room * x) / room : x);
    }
    return theta / Real(amplitude);
  }
  /// The mean of F between two concentrations that makes (C_i - C_j)/(theta_i - theta_j) exact: zero if either is 0 or
  /// 1, or beyond these by rounding.
  template <class Real>
  SCREE_FN Real mean(Real Ci, Real Cj, Real potential_i, Real potential_j) const {
    using namespace math;
    Real const difference = Ci - Cj;
    Real const least = max(Real(0), min(min(Ci, 1 - Ci), min(Cj, 1 - Cj)));
    // Below this the division loses digits and the midpoint value agrees with it to second order in the difference.
    Real const threshold = std::is_same_v<number_in<Real>, double> ? 1e-5 : 1e-3;
    auto const alike = max(difference, -difference) <= threshold * least;
    if constexpr (quotient_is_slow<Real>)
      if (alike) return value((Ci + Cj) / 2);
    Real const inside = select(alike, value((Ci + Cj) / 2), difference / (potential_i - potential_j));
    return select(least > Real(0), inside, Real(0));
  }
};

}  // namespace scree
