// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/pack.hpp"
#include "../core/root.hpp"
#include "../core/setting.hpp"

namespace scree {

/// The segregation function F(C) = A C (1 - C)(1 - kappa C) (Gajjar & Gray 2014; Zhu et al. 2024, eqs 2.8 and 2.9).
struct SegregationFlux {
  double amplitude = 1;  ///< A
  double asymmetry = 0;  ///< kappa

  /// Returns the symmetric function F = C (1 - C).
  static constexpr SegregationFlux symmetric() { return {}; }
  /// Returns the asymmetric flux function, with which a small grain among large ones percolates faster than a large
  /// grain among small ones rises. A is 1.6 as printed; with 1.596 the maximum of F would be that of the symmetric
  /// function.
  static constexpr SegregationFlux asymmetric() { return {.amplitude = 1.6, .asymmetry = 0.89}; }

  static constexpr auto parameters() {
    return std::array{parameter("amplitude", &SegregationFlux::amplitude, "1", "A of F = A C (1 - C)(1 - kappa C)",
                                allowed::between(0, 1e9)),
                      parameter("asymmetry", &SegregationFlux::asymmetry, "1", "kappa of F, towards fast small grains",
                                allowed::from_to(0, 1))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const { check_parameters(*this, "the segregation flux"); }
  /// Returns F at a concentration C.
  template <class Real>
  SCREE_FN Real value(Real C) const {
    return Real(amplitude) * C * (1 - C) * (1 - Real(asymmetry) * C);
  }
  /// Returns dF/dC at a concentration C.
  template <class Real>
  SCREE_FN Real slope(Real C) const {
    Real const kappa = Real(asymmetry);
    return Real(amplitude) * ((3 * kappa * C - 2 * (1 + kappa)) * C + 1);
  }
  /// Returns F between a particle that gives small grains and one that takes them, in the absence of diffusion: in a
  /// shock, where the giver has the lower concentration, the smaller of the two values of F; in a rarefaction fan, F at
  /// the mean concentration.
  template <class Real>
  SCREE_FN Real sharp(Real giver, Real taker) const {
    using namespace math;
    return select(giver < taker, min(value(giver), value(taker)), value((giver + taker) / 2));
  }
  /// Returns theta(C) = int dC/F = (ln C - ln(1 - C) + kappa ln(1 + (1 - kappa) x)/(1 - kappa))/A with x = C/(1 - C);
  /// for kappa = 1 the last logarithmic term is replaced by its limit, kappa x. The result is minus infinity for C <= 0
  /// and infinity for C >= 1.
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
  /// Returns the mean (C_i - C_j)/(theta_i - theta_j) of F between two concentrations; zero if either of them is 0 or
  /// 1, or is outside [0, 1] by rounding.
  template <class Real>
  SCREE_FN Real mean(Real Ci, Real Cj, Real potential_i, Real potential_j) const {
    using namespace math;
    Real const difference = Ci - Cj;
    Real const least = max(Real(0), min(min(Ci, 1 - Ci), min(Cj, 1 - Cj)));
    // Below this threshold the division loses digits, and F at the mean concentration agrees with its result to second
    // order in the difference.
    Real const threshold = std::is_same_v<number_in<Real>, double> ? 1e-5 : 1e-3;
    auto const alike = max(difference, -difference) <= threshold * least;
    if constexpr (quotient_is_slow<Real>)
      if (alike) return value((Ci + Cj) / 2);
    Real const inside = select(alike, value((Ci + Cj) / 2), difference / (potential_i - potential_j));
    return select(least > Real(0), inside, Real(0));
  }
};

}  // namespace scree
