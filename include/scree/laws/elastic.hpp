// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "law.hpp"

namespace scree {

/// Linear elasticity in rate form with the Jaumann rate, so that a rigid rotation only rotates the stress: $d\sigma/dt
/// = \omega \sigma - \sigma \omega + 2 G e + K \operatorname{tr}(\varepsilon) I$, with eps and omega the symmetric and
/// antisymmetric parts of L and e the deviator of eps (Zhu et al. 2024, eq. 2.16 with tr(eps) in place of eps_v).
struct Elastic {
  double young = 0;         ///< E
  double poisson = 0;       ///< nu
  double rest_density = 0;  ///< rho

  using reads = Fields<>;
  using history = Fields<>;

  static constexpr auto parameters() {
    return std::array{
        parameter("young", &Elastic::young, "Pa", "Young's modulus", allowed::above(0)),
        parameter("poisson", &Elastic::poisson, "1", "Poisson's ratio", allowed::between(-1, 0.5)),
        parameter("rest_density", &Elastic::rest_density, "kg/m^3", "density of the bulk at rest", allowed::above(0))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const { check_parameters(*this); }
  SCREE_FN double bulk_modulus() const { return young / (3 * (1 - 2 * poisson)); }
  /// Returns the shear modulus, Pa.
  SCREE_FN double shear_modulus() const { return young / (2 * (1 + poisson)); }
  SCREE_FN double density() const { return rest_density; }
  SCREE_FN double sound_speed() const {
    return Kokkos::sqrt((bulk_modulus() + 4 * shear_modulus() / 3) / rest_density);
  }

  template <class Real, class Point>
  SCREE_FN StressTensor<Real> stress_rate(StressTensor<Real> const& sigma, Mat<3, Real> const& L, Point const&) const {
    Real const K = Real(bulk_modulus()), G = Real(shear_modulus());
    Mat<3, Real> const eps = (L + transposed(L)) / 2;
    return rate_of_rotation(sigma, L) + 2 * G * eps + (K - 2 * G / 3) * trace(eps) * identity_matrix<Mat<3, Real>>();
  }
  /// Returns infinity: an elastic material does not yield.
  template <class Real, class Point>
  SCREE_FN Real shear_strength(Real, Point const&) const {
    return Kokkos::Experimental::infinity_v<Real>;
  }
  /// Returns the trial stress unchanged, even if it is NaN: every stress is admissible.
  template <class Real, class Point, class History>
  SCREE_FN StressTensor<Real> admissible(StressTensor<Real> const& trial, Point const&, History&&) const {
    return trial;
  }
};
static_assert(ConstitutiveLaw<Elastic>);

}  // namespace scree
