// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "elastic.hpp"
#include "return_mapping.hpp"

#include <cmath>

namespace scree {

/// Strength and flow parameters of a soil, as measured in laboratory tests. Its friction coefficient is tan(phi).
struct MohrCoulomb {
  double friction_angle = 0;   ///< phi, rad
  double cohesion = 0;         ///< c, Pa
  double dilatancy_angle = 0;  ///< psi, rad, 0 to phi

  static constexpr auto parameters() {
    constexpr double right = 1.5707963;
    return std::array{
        parameter("friction_angle", &MohrCoulomb::friction_angle, "rad", "angle of internal friction",
                  ParameterRange{0, right, false, true, "from 0 to below pi/2"}),
        parameter("cohesion", &MohrCoulomb::cohesion, "Pa", "shear strength without pressure", allowed::at_least(0)),
        parameter("dilatancy_angle", &MohrCoulomb::dilatancy_angle, "rad", "angle of dilatancy in shear",
                  ParameterRange{0, right, false, true, "from 0 to friction_angle"})};
  }
};
/// Throws std::invalid_argument if a parameter is out of range.
inline void check(MohrCoulomb const& soil) {
  check_parameters(soil, "MohrCoulomb");
  double const psi = soil.dilatancy_angle;
  check_setting(psi <= soil.friction_angle, "dilatancy_angle (rad) of MohrCoulomb", psi, "from 0 to friction_angle");
}

/// Returns the cone that yields like this Mohr-Coulomb material in steady plane strain, in which plastic flow stays in
/// the plane: (s1 - s2)/2 = P sin(phi) + c cos(phi), with P the pressure in the plane. In plane strain the cone dilates
/// with the angle psi. For psi = phi it is the cone of Drucker & Prager (1952), k = friction_ratio(tan(phi)); for psi =
/// 0, k = sin(phi). See docs/theory/laws.md.
inline Cone<double> plane_strain_cone(MohrCoulomb const& soil) {
  check(soil);
  double const k_psi = friction_ratio(std::tan(soil.dilatancy_angle)), sin_phi = std::sin(soil.friction_angle);
  double const all = std::sqrt(1 - k_psi * k_psi / 3) + sin_phi * k_psi / 3;
  return {
      .friction = sin_phi / all, .cohesion = soil.cohesion * std::cos(soil.friction_angle) / all, .dilatancy = k_psi};
}

/// Returns the cone through the triaxial compression edges of the Mohr-Coulomb pyramid, where the pyramid is strongest.
inline Cone<double> compression_cone(MohrCoulomb const& soil) {
  check(soil);
  double const sin_phi = std::sin(soil.friction_angle), sin_psi = std::sin(soil.dilatancy_angle);
  double const phi_part = 6 / (std::sqrt(3.0) * (3 - sin_phi)), psi_part = 6 / (std::sqrt(3.0) * (3 - sin_psi));
  return {.friction = phi_part * sin_phi,
          .cohesion = phi_part * soil.cohesion * std::cos(soil.friction_angle),
          .dilatancy = psi_part * sin_psi};
}

/// Elastic, perfectly plastic material with the cone of Drucker & Prager (1952), $\sqrt{J_2} \le k p + k_c$, as its
/// yield surface and with the plastic potential $\sqrt{J_2} - k_{\psi} p$. Tension is limited to p = -k_c/k;
/// TensionCutoff limits it further.
struct DruckerPrager {
  Elastic elastic = {};    ///< stiffness and density
  Cone<double> cone = {};  ///< plane_strain_cone(...), compression_cone(...), or {.friction = friction_ratio(mu)}

  using reads = Fields<>;
  using history = Fields<>;

  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const {
    elastic.check();
    cone.check();
  }
  SCREE_FN double bulk_modulus() const { return elastic.bulk_modulus(); }
  SCREE_FN double density() const { return elastic.density(); }
  SCREE_FN double sound_speed() const { return elastic.sound_speed(); }

  template <class Real, class Point>
  SCREE_FN StressTensor<Real> stress_rate(StressTensor<Real> const& sigma, Mat<3, Real> const& L,
                                          Point const& point) const {
    return elastic.stress_rate(sigma, L, point);
  }
  /// Returns $\sqrt{J_2}$ (Pa) at yield at a pressure p (Pa).
  template <class Real, class Point>
  SCREE_FN Real shear_strength(Real p, Point const&) const {
    return Kokkos::max(Real(cone.friction) * p + Real(cone.cohesion), Real(0));
  }
  template <class Real, class Point, class History>
  SCREE_FN StressTensor<Real> admissible(StressTensor<Real> const& trial, Point const&, History&&) const {
    return return_to_cone(trial, cone.cast<Real>(), Real(elastic.shear_modulus() / elastic.bulk_modulus()));
  }
};
static_assert(ConstitutiveLaw<DruckerPrager>);

}  // namespace scree
