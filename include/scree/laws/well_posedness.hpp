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

/// Whether the friction of a law is a function of the inertial number $I = \dot\gamma d/\sqrt{p/\rho_s}$. The law has
///   friction(p, gamma_dot, d)   mu for a pressure (Pa), a shear rate (1/s) and a grain diameter (m)
///   grain_density               the density of the grains rho_s, kg/m^3
template <class L>
concept FrictionOfInertialNumber = requires(L const& law, double x) {
  { law.friction(x, x, x) } -> std::convertible_to<double>;
  { law.grain_density } -> std::convertible_to<double>;
};

/// Returns k_mu of a law at an inertial number above 0, without the regularisation that acts at small shear rates.
template <FrictionOfInertialNumber Law>
double friction_ratio_at(Law const& law, double I) {
  double const gamma_dot = 1e9, d = 1;  // 1/s, m: lambda is negligible compared with this shear rate
  return friction_ratio(double(law.friction(law.grain_density * sq(gamma_dot * d / I), gamma_dot, d)));
}

/// Returns $C = k^2 (1 - r/2)^2 - 4 r (1 - r)$ with k = k_mu and r = (I/k) dk/dI, at an inertial number above 0. If C
/// is negative, the equations of incompressible plane flow with this law are well-posed: short waves are damped. If C
/// is positive, they are ill-posed: some waves grow, and shorter waves grow faster (Barker et al. 2015, whose mu is
/// k_mu here; derived in docs/theory/laws.md). C is NaN for a law without friction.
template <FrictionOfInertialNumber Law>
double ill_posedness(Law const& law, double I) {
  double const step = 1e-5, k = friction_ratio_at(law, I);
  double const rise = friction_ratio_at(law, I * std::exp(step)) - friction_ratio_at(law, I * std::exp(-step));
  double const r = rise / (2 * step * k);
  return sq(k * (1 - r / 2)) - 4 * r * (1 - r);
}

/// A range of inertial numbers, dimensionless.
struct InertialNumbers {
  double from = 0;                                      ///< the lower end
  double to = std::numeric_limits<double>::infinity();  ///< the upper end
};

namespace detail {
/// Returns the ranges in which a function is below zero; the search is described at well_posed_inertial_numbers().
[[gnu::cold]] std::vector<InertialNumbers> ranges_below_zero(std::function<double(double)> const& ill_posedness);
}  // namespace detail

/// Returns the ranges of the inertial number in which a law is well-posed (see ill_posedness()), in ascending order:
/// one range for MuOfI, none if its friction rises too little. The interval from 1e-8 to 1e6 is searched in steps of
/// 1/64 of a decade; a range that includes an end of this interval extends to 0 or infinity. The law must pass its
/// check().
template <FrictionOfInertialNumber Law>
std::vector<InertialNumbers> well_posed_inertial_numbers(Law const& law) {
  return detail::ranges_below_zero([&](double I) { return ill_posedness(law, I); });
}

/// Returns whether a law has friction and is ill-posed at every inertial number; for ByGroup, whether this holds for
/// the law of any group. Returns false for laws whose friction is not a function of the inertial number.
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
