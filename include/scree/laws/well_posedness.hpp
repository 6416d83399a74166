// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "law.hpp"

#include <cmath>
#include <concepts>
#include <functional>
#include <limits>
#include <vector>

namespace scree {

/// A law whose friction follows from the inertial number $I = \dot\gamma d/\sqrt{p/\rho_s}$:
///   friction(p, gamma_dot, d)   mu for a pressure (Pa), a shear rate (1/s) and a diameter of the grains (m)
///   grain_density               the density of the grains rho_s, kg/m^3
template <class L>
concept FrictionOfInertialNumber = requires(L const& law, double x) {
  { law.friction(x, x, x) } -> std::convertible_to<double>;
  { law.grain_density } -> std::convertible_to<double>;
};

/// k_mu of a law at an inertial number above 0, without the regularisation that acts at small shear rates.
template <FrictionOfInertialNumber Law>
double friction_ratio_at(Law const& law, double I) {
  double const gamma_dot = 1e9, d = 1;  // 1/s, m: lambda is nothing against this shear rate
  return friction_ratio(double(law.friction(law.grain_density * sq(gamma_dot * d / I), gamma_dot, d)));
}

/// $C = k^2 (1 - r/2)^2 - 4 r (1 - r)$ with k = k_mu and r = (I/k) dk/dI, at an inertial number above 0. Below zero the
/// equations of incompressible plane flow with this law are well-posed: short waves are damped. Above zero they are
/// ill-posed: some waves grow, and the faster the shorter they are (Barker et al. 2015, whose mu is k_mu here; derived
/// in docs/theory/laws.md). NaN for a law without friction.
template <FrictionOfInertialNumber Law>
double ill_posedness(Law const& law, double I) {
  double const step = 1e-5, k = friction_ratio_at(law, I);
  double const rise = friction_ratio_at(law, I * std::exp(step)) - friction_ratio_at(law, I * std::exp(-step));
  double const r = rise / (2 * step * k);
  return sq(k * (1 - r / 2)) - 4 * r * (1 - r);
}

/// Inertial numbers between two ends, -.
struct InertialNumbers {
  double from = 0;                                      ///< the lower end
  double to = std::numeric_limits<double>::infinity();  ///< the upper end
};

namespace detail {
/// The ranges in which a function is below zero, searched as well_posed_inertial_numbers() says.
[[gnu::cold]] std::vector<InertialNumbers> ranges_below_zero(std::function<double(double)> const& ill_posedness);
}  // namespace detail

/// The ranges of the inertial number in which a law is well-posed (see ill_posedness()), from the lowest one on: one
/// for MuOfI, none if its friction rises too little. They are searched between 1e-8 and 1e6, in steps of 1/64 of a
/// decade; a range that includes an end of this interval extends to 0 or infinity. The law must pass its check().
template <FrictionOfInertialNumber Law>
std::vector<InertialNumbers> well_posed_inertial_numbers(Law const& law) {
  return detail::ranges_below_zero([&](double I) { return ill_posedness(law, I); });
}

/// Whether a law has friction and is well-posed for no inertial number; of a law by group, whether that of a group is.
/// False for laws whose friction does not follow from the inertial number.
template <class Law>
bool is_never_well_posed(Law const& law) {
  if constexpr (FrictionOfInertialNumber<Law>) {
    return friction_ratio_at(law, 1) > 0 && well_posed_inertial_numbers(law).empty();
  } else if constexpr (requires { law.of(law.groups()); }) {
    for (int k = 0; k < law.groups(); ++k)
      if (is_never_well_posed(law.of(k))) return true;
  }
  return false;
}

}  // namespace scree

#ifndef SCREE_COMPILED
#include "well_posedness.ipp"
#endif
