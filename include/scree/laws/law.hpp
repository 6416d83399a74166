// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/record.hpp"
#include "../fields/standard.hpp"

#include <concepts>

// A constitutive law is a struct of parameters with functions of one point. It does not know particles or indices.
namespace scree {

/// For laws without internal variables.
struct NoHistory {};

/// Stress as laws see it: 3 x 3, symmetric, Pa, tension positive; in 2D the third direction is out of the plane.
template <class Real>
using StressTensor = Mat<3, Real>;

/// Pressure p = -tr(sigma)/3, Pa, compression positive.
template <class Real>
SCREE_FN Real pressure_of(StressTensor<Real> const& sigma) {
  return -trace(sigma) / 3;
}
/// Deviator s = sigma + p I.
template <class Real>
SCREE_FN StressTensor<Real> deviator_of(StressTensor<Real> const& sigma) {
  return sigma + pressure_of(sigma) * identity_matrix<StressTensor<Real>>();
}
/// sqrt(J2) = sqrt(s:s/2) of a deviator.
template <class Real>
SCREE_FN Real equivalent_shear_stress(StressTensor<Real> const& s) {
  return Kokkos::sqrt(squared_norm(s) / 2);
}
/// k_mu in sqrt(J2) = k_mu p for the friction coefficient mu of a Mohr-Coulomb material in plane strain with an
/// associated flow rule: Zhu et al. (2024), eq. 2.12. With isochoric flow it is itself the ratio of shear stress to
/// pressure in simple shear.
template <class Real>
SCREE_FN Real friction_ratio(Real mu) {
  return 3 * mu / Kokkos::sqrt(9 + 12 * mu * mu);
}

namespace detail {
/// The basis in which the concept below checks a law.
struct AnyPoint {
  static constexpr int dim = 3;
  using real = double;
};
template <class L>
using PointOf = Record<AnyPoint, Merge<typename L::reads, typename L::history>>;
template <class L>
using MemoryOf = Results<AnyPoint, typename L::history>;
}  // namespace detail

/// A constitutive law:
///   reads                              fields of the point that its strength depends on
///   history                            fields of its internal variables; Fields<> if it has none
///   density()                          at rest, kg/m^3
///   sound_speed()                      of compression waves, m/s
///   bulk_modulus()                     Pa
///   stress_rate(sigma, L)              Pa/s, symmetric, for the velocity gradient L_ab = du_a/dx_b (1/s)
///   admissible(trial, point, memory)   return mapping: the stress that the material can carry, from the trial
///                                      stress of the rate alone; `point` holds the fields in `reads` and the old
///                                      history, `memory` takes all of the new one. A NaN gives zero stress or NaN,
///                                      never a stress beyond yield.
/// Functions return evaluated tensors: an Eigen expression would outlive the values it refers to.
/// Laws with a yield surface also have shear_strength(p, point), the largest sqrt(J2) at a pressure p (Pa).
template <class L>
concept ConstitutiveLaw = requires(L const& law, StressTensor<double> const& sigma, detail::PointOf<L> const& point,
                                   detail::MemoryOf<L>& memory) {
  typename L::reads;
  typename L::history;
  { law.density() } -> std::convertible_to<double>;
  { law.sound_speed() } -> std::convertible_to<double>;
  { law.bulk_modulus() } -> std::convertible_to<double>;
  { law.stress_rate(sigma, sigma) } -> std::same_as<StressTensor<double>>;
  { law.admissible(sigma, point, memory) } -> std::same_as<StressTensor<double>>;
};

}  // namespace scree
