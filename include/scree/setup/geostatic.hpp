// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"
#include "../laws/circular_cone.hpp"
#include "../laws/matsuoka_nakai.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

// Stress in a bed at rest. At the depth d below a level surface, the vertical compression is q = density gravity d and
// the horizontal one is K0 q in both directions: sigma = -q diag(1, K0, K0) in axes (up, horizontal, horizontal), with
//
//   p  = -tr(sigma)/3 = q (1 + 2 K0)/3
//   s  = sigma + p I  = q (1 - K0)/3 diag(-2, 1, 1)
//   J2 = s:s/2        = q^2 (1 - K0)^2/3
//   sqrt(J2)/p        = sqrt(3) |1 - K0|/(1 + 2 K0)
//
// at every depth. The stress is within a yield surface with the ratios k_c in triaxial compression and k_e in triaxial
// extension (both are k on a circular cone sqrt(J2) = k p) if sqrt(J2)/p does not exceed these ratios:
//
//   K0 >= (sqrt(3) - k_c)/(sqrt(3) + 2 k_c)    otherwise the bed spreads,
//   K0 <= (sqrt(3) + k_e)/(sqrt(3) - 2 k_e)    otherwise it is squeezed upwards; no limit for 2 k_e >= sqrt(3).
namespace scree {

/// Returns $\sqrt{J_2}/p$ of a bed at rest.
inline double geostatic_stress_ratio(double K0) { return std::sqrt(3.0) * std::abs(1 - K0) / (1 + 2 * K0); }

namespace detail {
/// A yield section with the smaller of the ratios of CircularCone, which models in the plane have by default, and of
/// MatsuokaNakai, which models in space have by default.
struct WithinBothSections {
  template <class Real>
  Real ratio(Real k, Real cosine) const {
    return std::min(CircularCone{}.ratio(k, cosine), MatsuokaNakai{}.ratio(k, cosine));
  }
  template <class Real>
  Real least_ratio(Real k) const {
    return std::min(CircularCone{}.least_ratio(k), MatsuokaNakai{}.least_ratio(k));
  }
};
}  // namespace detail

/// Returns the smallest K0 for which the stress in a bed at rest is within the yield surface of a material with this
/// friction in plane shear. Without a section, the value holds for both sections that models have by default,
/// CircularCone and MatsuokaNakai. Throws std::invalid_argument for a friction below 0.
template <YieldSection S = detail::WithinBothSections>
double least_admissible_K0(double friction, S const& section = {}) {
  if (!(friction >= 0)) throw std::invalid_argument("set-up: friction must not be negative");
  double const k = section.ratio(friction, 1.0);
  return std::max(0.0, (std::sqrt(3.0) - k) / (std::sqrt(3.0) + 2 * k));
}
/// Returns the largest K0 for which the stress in a bed at rest is within the yield surface of a material with this
/// friction in plane shear. Without a section, the value holds for both sections that models have by default,
/// CircularCone and MatsuokaNakai. Throws std::invalid_argument for a friction below 0.
template <YieldSection S = detail::WithinBothSections>
double greatest_admissible_K0(double friction, S const& section = {}) {
  if (!(friction >= 0)) throw std::invalid_argument("set-up: friction must not be negative");
  double const k = section.ratio(friction, -1.0), rest = std::sqrt(3.0) - 2 * k;
  return rest > 0 ? (std::sqrt(3.0) + k) / rest : std::numeric_limits<double>::infinity();
}

/// The initial stress of a bed at rest below a level surface, as a function of the position. The last coordinate points
/// upwards.
struct Geostatic {
  double surface_height = 0;  ///< m
  double density = 0;         ///< of the bed, kg/m^3
  double gravity = 0;         ///< magnitude, m/s^2
  double K0 = 1;              ///< ratio of horizontal to vertical stress; 1: hydrostatic

  /// Returns the stress at x, Pa, tension positive; zero above the surface. Axes in 3D: x, y, up; in 2D: x, up, out of
  /// the plane.
  template <class X>
  Mat<3, double> operator()(Eigen::MatrixBase<X> const& x) const {
    static constexpr int dim = X::RowsAtCompileTime;
    static_assert(dim == 2 || dim == 3, "scree: a position has two or three coordinates");
    double const depth = std::max(0.0, surface_height - double(x[dim - 1]));
    double const upward = -density * gravity * depth;
    Mat<3, double> sigma = Mat<3, double>::Zero();
    sigma.diagonal().setConstant(K0 * upward);
    sigma(dim - 1, dim - 1) = upward;
    return sigma;
  }
};

/// Returns `bed` if its stress is within the yield surface of a material with this friction in plane shear. Without a
/// section, the stress must be within both sections that models have by default, CircularCone and MatsuokaNakai. Throws
/// std::invalid_argument otherwise, and if the density, the gravity or the friction is negative.
template <YieldSection S = detail::WithinBothSections>
Geostatic admissible(Geostatic const& bed, double friction, S const& section = {}) {
  if (!(bed.density >= 0 && bed.gravity >= 0))
    throw std::invalid_argument("set-up: density and gravity of a bed must not be negative");
  double const least = least_admissible_K0(friction, section), greatest = greatest_admissible_K0(friction, section);
  double const rounding = 1e-12;  // the limits themselves are admissible
  if (bed.K0 >= least - rounding && bed.K0 <= greatest + rounding) return bed;
  std::string const advice = std::is_same_v<S, detail::WithinBothSections>
                                 ? " on a circular cone and on MatsuokaNakai; on one of them: admissible(bed, "
                                   "friction, CircularCone{}) for sand in the plane, MatsuokaNakai{} in space"
                                 : "";
  throw std::invalid_argument("set-up: K0 = " + std::to_string(bed.K0) +
                              " lies outside the yield surface of the friction " + std::to_string(friction) +
                              ", which admits " + std::to_string(least) + " to " + std::to_string(greatest) + advice);
}

}  // namespace scree
