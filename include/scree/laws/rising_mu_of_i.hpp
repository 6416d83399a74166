// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "mu_of_i.hpp"

namespace scree {

/// A variant of MuOfI in which friction continues to rise at large inertial numbers,
///   mu = (mu_s I0 + mu_d I + mu_inf I^2)/(I0 + I)
/// (Barker & Gray 2017, the branch for large I), so that the law is well-posed up to a larger I. All other functions
/// are inherited from MuOfI, which is the base class and is initialised first: RisingMuOfI<>{{.elastic = ..., .grains =
/// ...}, 0.05}. $\sqrt{J_2}/p$ stays below $\sqrt{3}/2$, as k_mu does for any mu. I is limited to 1e6, so that mu is
/// finite at zero pressure.
///
/// The branch of Barker & Gray for small I, $\mu = \sqrt{\alpha/\ln(A/I)}$, is omitted: it falls to zero with I, so
/// that no slope would come to rest. Heaps and beds need a yield stress, mu_s > 0; the law therefore remains ill-posed
/// at small I.
template <class GrainModel = UniformGrains>
struct RisingMuOfI : MuOfI<GrainModel> {
  double mu_inf = 0.05;

  static constexpr auto parameters() {
    return std::array{parameter("mu_inf", &RisingMuOfI::mu_inf, "1",
                                "rise of the friction per unit of a large inertial number", allowed::from_to(0, 10))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const {
    check_settings_of(static_cast<MuOfI<GrainModel> const&>(*this));
    check_parameters(*this, "RisingMuOfI");
  }
  /// Returns mu for a pressure (Pa; a negative pressure is taken as zero), a shear rate (1/s) and a grain diameter (m).
  /// With the regularisation lambda it is mu of MuOfI with mu_d + mu_inf I in place of mu_d.
  template <class Real>
  SCREE_FN Real friction(Real p, Real gamma_dot, Real d) const {
    // min() returns the first argument if the second is NaN, as it is for zero shear at zero pressure.
    Real const I =
        Kokkos::min(Real(1e6), gamma_dot * d / Kokkos::sqrt(Kokkos::max(p, Real(0)) / Real(this->grain_density)));
    return this->friction_rising_by(Real(this->mu_d - this->mu_s) + Real(mu_inf) * I, p, gamma_dot, d);
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
static_assert(ConstitutiveLaw<RisingMuOfI<>>);

}  // namespace scree
