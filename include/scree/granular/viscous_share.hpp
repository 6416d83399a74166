// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../kernels/default_bases.hpp"
#include "../laws/law.hpp"
#include "../passes/sums.hpp"
#include "../terms/artificial_viscosity.hpp"

#include <string>

// How much of a flow its artificial viscosity rules.
namespace scree {
namespace granular {

/// The momentum of a particle over the density, and the same where the viscosity rules its shear: where its stress is
/// above that of the material, and its power above a part of that of the weight.
template <int Dim>
struct ViscousMomentum {
  static constexpr int count = 2;
  using reads = Fields<Volume, Velocity, Stress, ShearRate>;
  double viscosity;     // of h = 1 m, Pa s
  double least_weight;  // N/m^3
  template <class I>
  SCREE_FN Vec<2, double> operator()(I const& i) const {
    using namespace fields;
    double const V = double(i[volume]), rate = double(i[shear_rate]), speed = double(norm(i[velocity]));
    double const viscous = viscosity * 1.5 * Kokkos::pow(V, 1.0 / Dim) * rate;
    bool const rules = viscous > double(equivalent_shear_stress(deviator_of(unpacked(i[stress])))) &&
                       viscous * rate > least_weight * speed;
    return {V * speed, rules ? V * speed : 0};
  }
};

}  // namespace granular

/// The share of the momentum of a body (WholeBody) that is of particles whose shear the artificial viscosity `speed`
/// (m/s) rules, 0 to 1: its stress, with h of 1.5 spacings, is above that of the material, and its power above 15 % of
/// that of their weight, were they falling. Density (kg/m^3) and gravity (m/s^2) are those of the body, which has
/// Volume, Velocity, Stress and ShearRate. 0 without gravity. It runs on the device.
template <class... Of>
[[gnu::cold]] double viscous_share(WholeBody<Of...> const& body, double speed, double density, double gravity) {
  constexpr int dim = WholeBody<Of...>::policy::dim;
  if (!(gravity > 0)) return 0;
  granular::ViscousMomentum<dim> const momentum{density * effective_viscosity(speed, 1, dim), 0.15 * density * gravity};
  auto const sums = sums_over(body, momentum, "the share of the artificial viscosity");
  return sums[0] > 0 ? sums[1] / sums[0] : 0;
}
/// Returns a warning if the artificial viscosity `speed` (m/s) dominates in more than half of a flow (`share` is the
/// result of viscous_share()), and an empty string otherwise. At 0.5 m/s, the share is at most 0.44, and only briefly,
/// in rain, on slopes, in drums of 20 rows and in collapses of 0.1 m and 1 m; in a collapse of 0.1 m at 10 m/s, it is
/// 0.6 to 0.8.
[[gnu::cold]] inline std::string warning_of_viscosity(double share, double speed) {
  if (!(share > 0.5)) return "";
  return detail::formatted(
      "scree: warning: on %.0f %% of the material that moves the artificial viscosity acts more than the stress: a "
      "viscosity_speed of %.4g m/s makes it thicker than it is; take a smaller one, or `using viscosity = "
      "ResidualViscosity` in the models (docs/choosing.md, artificial viscosity)",
      100 * share, speed);
}

}  // namespace scree

#ifdef SCREE_COMPILED
#define SCREE_INSTANCES(P) \
  SCREE_INSTANCE double scree::viscous_share(scree::WholeBody<scree::AnyParticles<P>> const&, double, double, double)
SCREE_FOR_DEFAULT_BASES(SCREE_INSTANCES);
#undef SCREE_INSTANCES
#endif
