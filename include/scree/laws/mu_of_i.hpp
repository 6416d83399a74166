// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "elastic.hpp"
#include "grains.hpp"
#include "plausible.hpp"
#include "relative_density.hpp"
#include "return_mapping.hpp"

#include <utility>

namespace scree {
namespace detail {
/// Returns the length d (m) in the inertial number $\dot\gamma d \sqrt{\rho_s/p}$, in which rho_s is the grain density
/// of the law: the mean diameter, times the square root of the relative density for a mixture.
template <class Grains, class Point>
SCREE_FN double inertial_length(Grains const& grains, Point const& point) {
  if constexpr (KnowsRelativeDensity<Point>)
    return grains.mean_diameter(point) * Kokkos::sqrt(point.relative_density);
  else
    return grains.mean_diameter(point);
}
/// Returns k_mu of a law with grains and `friction(p, gamma_dot, d)`, at a point and a pressure (Pa).
template <class Law, class Real, class Point>
SCREE_FN Real friction_ratio_of(Law const& law, Real p, Point const& point) {
  return friction_ratio(law.friction(p, Real(point[fields::shear_rate]), Real(inertial_length(law.grains, point))));
}
template <class G>
constexpr bool explain_grains() {
  constexpr bool are_sizes = GrainSizes<G>;
  static_assert(are_sizes, "the grains of MuOfI need a list `reads`, and mean_diameter(point) const, which returns m");
  return are_sizes;
}
}  // namespace detail

/// Elastoplastic granular material whose friction depends on the inertial number $I = \dot\gamma d/\sqrt{p/\rho_s}$,
/// with the yield surface $\sqrt{J_2} \le k_\mu p$ and $\mu = \mu_s + (\mu_d - \mu_s) \dot\gamma/(I_0 \sqrt{p/(\rho_s
/// d^2)} + \sqrt{\dot\gamma^2 + \lambda^2})$ (Jop et al. 2006; Zhu et al. 2024, eqs 2.11 to 2.15). The material is
/// cohesionless, and its flow is isochoric. The yield surface is a circular cone unless the point passed to the law
/// specifies another section, which then touches this cone in plane shear. In 3D, Granular specifies MatsuokaNakai
/// unless its models name another section. The density in `elastic` is the bulk density of grains and voids together.
template <class GrainModel = UniformGrains>
struct MuOfI {
  static constexpr bool cohesionless = true;
  static constexpr bool takes_section = true;
  static constexpr double largest_friction = 10;  ///< upper limit of mu_s and mu_d; for sand they are 0.3 to 1
  Elastic elastic = {};                           ///< stiffness and density
  GrainModel grains = {};                         ///< the diameter of the grains
  double mu_s = 0.382;                            ///< tangent of a friction angle, 0 to 10
  double mu_d = 0.682;                            ///< mu_s to 10
  double I0 = 0.279;
  double grain_density = 2500;   ///< rho_s, at least the density of `elastic`
  double regularisation = 1e-3;  ///< lambda

  using reads = Merge<Fields<ShearRate>, reads_of<GrainModel>>;
  using history = Fields<>;

  static constexpr auto parameters() {
    return std::array{
        parameter("mu_s", &MuOfI::mu_s, "1", "friction at rest", allowed::at_least(0)),
        parameter("mu_d", &MuOfI::mu_d, "1", "friction at large inertial number", allowed::at_least(0, "mu_s or more")),
        parameter("I0", &MuOfI::I0, "1", "inertial number at which the friction is halfway between both",
                  allowed::above(0)),
        parameter("grain_density", &MuOfI::grain_density, "kg/m^3", "density of the solid, in the inertial number",
                  allowed::above(0)),
        parameter("regularisation", &MuOfI::regularisation, "1/s", "lambda, small against the shear rates of the flow",
                  allowed::above(0))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const {
    elastic.check();
    check_settings_of(grains);
    check_parameters(*this, "MuOfI");
    for (auto const& [name, mu] : {std::pair("mu_s (-) of MuOfI", mu_s), std::pair("mu_d (-) of MuOfI", mu_d)})
      check_setting(mu <= largest_friction, name, mu,
                    "at most 10: it is the tangent of a friction angle, not the angle in degrees");
    check_setting(mu_d >= mu_s, "mu_d (-) of MuOfI", mu_d, "mu_s or more");
    if (mu_d > mu_s) detail::check_density_of_bed(elastic.rest_density, grain_density, "MuOfI");
  }
  SCREE_FN double bulk_modulus() const { return elastic.bulk_modulus(); }
  SCREE_FN double density() const { return elastic.density(); }
  SCREE_FN double sound_speed() const { return elastic.sound_speed(); }

  /// Returns mu for a pressure (Pa; a negative pressure is taken as zero), a shear rate (1/s) and a grain diameter (m).
  template <class Real>
  SCREE_FN Real friction(Real p, Real gamma_dot, Real d) const {
    return friction_rising_by(Real(mu_d - mu_s), p, gamma_dot, d);
  }
  /// Returns the friction coefficient of friction() with `rise` in place of mu_d - mu_s.
  template <class Real>
  SCREE_FN Real friction_rising_by(Real rise, Real p, Real gamma_dot, Real d) const {
    Real const lambda = Real(regularisation);
    Real const inertial = Real(I0) * Kokkos::sqrt(Kokkos::max(p, Real(0)) / Real(grain_density)) / d;
    return Real(mu_s) + rise * gamma_dot / (inertial + Kokkos::sqrt(gamma_dot * gamma_dot + lambda * lambda));
  }
  template <class Real, class Point>
  SCREE_FN StressTensor<Real> stress_rate(StressTensor<Real> const& sigma, Mat<3, Real> const& L,
                                          Point const& point) const {
    return elastic.stress_rate(sigma, L, point);
  }
  /// Returns $\sqrt{J_2}$ (Pa) at yield in plane shear at a pressure p (Pa) and the present shear rate.
  template <class Real, class Point>
  SCREE_FN Real shear_strength(Real p, Point const& point) const {
    return detail::friction_ratio_of(*this, p, point) * Kokkos::max(p, Real(0));
  }
  /// Returns the stress on the yield surface, with mu at the pressure of the trial stress, which the return mapping
  /// does not change.
  template <class Real, class Point, class History>
  SCREE_FN StressTensor<Real> admissible(StressTensor<Real> const& trial, Point const& point, History&&) const {
    return return_to_yield(trial, detail::friction_ratio_of(*this, pressure_of(trial), point), point);
  }
};

/// A law whose grain model has a mistake, which the compiler has already reported; the rest of the law is not compiled.
template <class GrainModel>
requires(!detail::explain_grains<GrainModel>()) struct MuOfI<GrainModel> {
  using refused = GrainModel;
};
static_assert(ConstitutiveLaw<MuOfI<>>);

}  // namespace scree
