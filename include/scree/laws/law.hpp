// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/member.hpp"
#include "../fields/rate.hpp"
#include "../fields/record.hpp"
#include "../fields/standard.hpp"

#include <concepts>

// A constitutive law is a struct of parameters whose functions are evaluated at one point. It knows nothing of
// particles or indices.
namespace scree {

/// A point without fields, for laws that read no fields and have no internal variables.
struct NoHistory {};

/// The stress tensor of laws: 3 x 3, symmetric, Pa, tension positive. In 2D the third direction is normal to the plane.
template <class Real>
using StressTensor = Mat<3, Real>;

/// Returns the pressure p = -tr(sigma)/3, Pa, positive in compression.
template <class Real>
SCREE_FN Real pressure_of(StressTensor<Real> const& sigma) {
  return -trace(sigma) / 3;
}
/// Returns the stress deviator s = sigma + p I.
template <class Real>
SCREE_FN StressTensor<Real> deviator_of(StressTensor<Real> const& sigma) {
  return sigma + pressure_of(sigma) * identity_matrix<StressTensor<Real>>();
}
/// Returns $\sqrt{J_2} = \sqrt{s:s/2}$ of a deviator s.
template <class Real>
SCREE_FN Real equivalent_shear_stress(StressTensor<Real> const& s) {
  return Kokkos::sqrt(squared_norm(s) / 2);
}
/// Returns k_mu in $\sqrt{J_2} = k_{\mu} p$ for the friction coefficient mu of a Mohr-Coulomb material in plane strain
/// with an associated flow rule: Zhu et al. (2024), eq. 2.12. If the flow is isochoric, k_mu is the ratio of shear
/// stress to pressure in simple shear.
template <class Real>
SCREE_FN Real friction_ratio(Real mu) {
  return 3 * mu / Kokkos::sqrt(9 + 12 * mu * mu);
}

/// Returns $\sigma \omega^T + \omega \sigma$, with omega the spin of L: the rate of a stress that only rotates with the
/// material. An objective law adds this rate to its Jaumann rate.
template <class Real>
SCREE_FN StressTensor<Real> rate_of_rotation(StressTensor<Real> const& sigma, Mat<3, Real> const& L) {
  Mat<3, Real> const omega = (L - transposed(L)) / 2, turned = omega * sigma;
  return turned + transposed(turned);
}

namespace detail {
using AnyStress = StressTensor<double>;
template <class L>
using PointOf = Record<AnyPoint, Merge<typename L::reads, typename L::history>>;
template <class L>
using MemoryOf = Results<AnyPoint, typename L::history>;
template <class L>
using RatesOf = Results<AnyPoint, rates_of_evolved<typename L::history>>;

template <class L>
concept NamesFields = requires {
  typename L::reads;
  typename L::history;
};
template <class L>
concept GivesDensity = requires(L const& law) {
  { law.density() } -> std::convertible_to<double>;
};
template <class L>
concept GivesDensityOfPoint = requires(L const& law, PointOf<L> const& point) {
  { law.density(point) } -> std::convertible_to<double>;
};
template <class L>
concept GivesStressRate = requires(L const& law, AnyStress const& sigma, PointOf<L> const& point) {
  { law.stress_rate(sigma, sigma, point) } -> std::same_as<AnyStress>;
};
template <class L>
concept GivesHistoryRate = requires(L const& law, AnyStress const& sigma, PointOf<L> const& point, RatesOf<L>& rates) {
  law.history_rate(sigma, sigma, point, rates);
};
template <class L>
concept GivesAdmissible = requires(L const& law, AnyStress const& sigma, PointOf<L> const& point, MemoryOf<L>& memory) {
  { law.admissible(sigma, point, memory) } -> std::same_as<AnyStress>;
};
}  // namespace detail

/// Whether the elastic moduli of a law are independent of the state: it has bulk_modulus() and sound_speed().
template <class L>
concept ConstantStiffness = requires(L const& law) {
  { law.bulk_modulus() } -> std::convertible_to<double>;
  { law.sound_speed() } -> std::convertible_to<double>;
};
/// Whether the moduli of a law depend on the state, that is, whether the law has bulk_modulus(sigma, point) and
/// sound_speed(sigma, point).
template <class L>
concept StiffnessOfState = requires(L const& law, StressTensor<double> const& sigma, detail::PointOf<L> const& point) {
  { law.bulk_modulus(sigma, point) } -> std::convertible_to<double>;
  { law.sound_speed(sigma, point) } -> std::convertible_to<double>;
};
/// Whether a law has internal variables with rates.
template <class L>
concept EvolvesHistory = !std::is_same_v<rates_of_evolved<typename L::history>, Fields<>>;

/// A constitutive law. Its functions, except those without arguments, are evaluated at one point:
///   reads                               fields of the point that the law depends on, except the stress; Fields<> if
///                                       there are none
///   history                             fields of its internal variables; Fields<> if there are none. A field that
///                                       names a `rate` is integrated in time, like the stress
///   density()                           the density at rest, kg/m^3, of a law for one material
///   density(point)                      the density at rest at a point, kg/m^3, of a law for several materials, in
///                                       place of density()
///   bulk_modulus()                      the bulk modulus, Pa, of a law of constant stiffness
///   sound_speed()                       the speed of compression waves, m/s, of a law of constant stiffness
///   bulk_modulus(sigma, point)          the bulk modulus at a stress, Pa, above 0 even at zero stress
///   sound_speed(sigma, point)           the speed of compression waves at a stress, m/s, above 0 even at zero stress
///   stress_rate(sigma, L, point)        the rate of the stress, Pa/s, symmetric, for the velocity gradient
///                                       L_ab = du_a/dx_b (1/s)
///   history_rate(sigma, L, point, rates)  only if a field in `history` names a rate: sets each of these rates
///   admissible(trial, point, memory)    return mapping: returns the stress that the material can carry, given the
///                                       trial stress that results from the rate alone. `memory` holds the old history
///                                       and takes the new one. For NaN it returns zero stress or NaN, never a stress
///                                       beyond yield
/// `point` holds the fields in `reads` and `history`. In stress_rate() and history_rate() the shear rate of the point
/// is that of the present state; other fields computed by passes have their values from the last evaluation of the
/// rates. Functions return evaluated tensors, because an Eigen expression would outlive the values that it refers to. A
/// law with a yield surface also has shear_strength(p, point), which returns $\sqrt{J_2}$ (Pa) at yield in plane shear
/// at a pressure p (Pa); on a circular cone it is the same in all directions. A law for cohesionless grains has a
/// constant `cohesionless` = true, see Cohesionless. A law with the strength of sand in 3D uses the section of its
/// point and has a constant `takes_section` = true, see TakesSection.
template <class L>
concept ConstitutiveLaw = detail::NamesFields<L> &&
                          (detail::GivesDensity<L> || detail::GivesDensityOfPoint<L>)&&detail::GivesStressRate<L> &&
                          (ConstantStiffness<L> ||
                           StiffnessOfState<L>)&&(!EvolvesHistory<L> ||
                                                  detail::GivesHistoryRate<L>)&&detail::GivesAdmissible<L>;

/// Whether a law declares that its material cannot bear tension. For a cohesionless law the pressure follows the
/// packing where grains flow or carry no load, unless the models of Granular name another volume control.
template <class L>
concept Cohesionless = requires {
  requires L::cohesionless;
};

namespace detail {
/// Returns whether a type is a constitutive law. Each missing part fails a static assertion with its own message.
template <class L>
constexpr bool explain_law() {
  static_assert(NamesFields<L> || IsRefused<L>,
                "this law needs lists `reads` and `history` of fields, which may be Fields<>");
  if constexpr (NamesFields<L>) {
    static_assert(GivesDensity<L> || GivesDensityOfPoint<L>, "this law needs density() or density(point), in kg/m^3");
    static_assert(ConstantStiffness<L> || StiffnessOfState<L>,
                  "this law needs bulk_modulus() and sound_speed(), or both as functions of the state, (sigma, point)");
    static_assert(GivesStressRate<L>,
                  "this law needs stress_rate(sigma, L, point), which returns a StressTensor and reads no field that "
                  "is missing in `reads` and `history`");
    static_assert(!EvolvesHistory<L> || GivesHistoryRate<L>,
                  "a field in `history` of this law names a rate: the law needs history_rate(sigma, L, point, rates)");
    static_assert(EvolvesHistory<L> || !GivesHistoryRate<L>,
                  "this law has a history_rate(), but no field in its `history` names a rate");
    static_assert(!(GivesDensity<L> && GivesDensityOfPoint<L>), "this law has both density() and density(point)");
    static_assert(!(ConstantStiffness<L> && StiffnessOfState<L>),
                  "this law has bulk_modulus() and sound_speed() both as constants and as functions of the state");
    static_assert(GivesAdmissible<L>,
                  "this law needs admissible(trial, point, memory), which returns a StressTensor; a law without a "
                  "yield surface returns `trial`");
  }
  return ConstitutiveLaw<L>;
}
}  // namespace detail

/// Returns the bulk modulus of a law at a point, Pa.
template <class Law, class Real, class Point>
SCREE_FN Real bulk_modulus_at(Law const& law, [[maybe_unused]] StressTensor<Real> const& sigma,
                              [[maybe_unused]] Point const& point) {
  if constexpr (ConstantStiffness<Law>)
    return Real(law.bulk_modulus());
  else
    return Real(law.bulk_modulus(sigma, point));
}
/// Returns the speed of compression waves of a law at a point, m/s.
template <class Law, class Real, class Point>
SCREE_FN Real sound_speed_at(Law const& law, [[maybe_unused]] StressTensor<Real> const& sigma,
                             [[maybe_unused]] Point const& point) {
  if constexpr (ConstantStiffness<Law>)
    return Real(law.sound_speed());
  else
    return Real(law.sound_speed(sigma, point));
}

}  // namespace scree
