// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../kernels/default_bases.hpp"
#include "../laws/law.hpp"
#include "../passes/sums.hpp"
#include "../terms/artificial_viscosity.hpp"

#include <cmath>
#include <string>

// What an artificial viscosity takes from a flow, beside the stress of the material.
namespace scree {
namespace granular {

/// The power of the stress in shear, the squared shear rate over h^2 of 1.5 spacings, and the speed, times the volume.
template <int Dim>
struct PowerSums {
  static constexpr int count = 3;
  using reads = Fields<Volume, Velocity, Stress, ShearRate>;
  template <class I>
  SCREE_FN Vec<3, double> operator()(I const& i) const {
    using namespace fields;
    double const V = double(i[volume]), rate = double(i[shear_rate]);
    double const h = 1.5 * Kokkos::pow(V, 1.0 / Dim);
    return {V * rate * double(equivalent_shear_stress(deviator_of(unpacked(i[stress])))), V * h * rate * rate,
            V * double(norm(i[velocity]))};
  }
};

}  // namespace granular

/// Power in the shear of a flow, W (per metre in a plane).
struct ViscousPower {
  double of_viscosity = 0;  ///< of the artificial viscosity, with h of 1.5 spacings
  double of_stress = 0;     ///< of the stress of the material
  double of_weight = 0;     ///< of the weight, were all velocities along gravity
};
/// The power of the artificial viscosity `speed` (m/s) in a body (WholeBody) of a density (kg/m^3) under a gravity
/// (m/s^2), whose particles have Volume, Velocity, Stress and ShearRate. It runs on the device.
template <class... Of>
[[gnu::cold]] ViscousPower viscous_power(WholeBody<Of...> const& body, double speed, double density, double gravity) {
  constexpr int dim = WholeBody<Of...>::policy::dim;
  auto const sums = sums_over(body, granular::PowerSums<dim>{}, "the power of the artificial viscosity");
  return {density * effective_viscosity(speed, 1, dim) * sums[1], sums[0], density * gravity * sums[2]};
}
/// The warning of an artificial viscosity `speed` (m/s) that takes more from a flow than its friction does, by a fifth;
/// empty for others, without gravity, and where it is little beside the weight, as in a bed that comes to rest.
/// Collapses, slopes and drums of 20 rows have up to 1.0 times with 0.5 m/s, for a moment, and 2 to 9 with 10 m/s.
[[gnu::cold]] inline std::string warning_of_viscosity(ViscousPower const& found, double speed) {
  bool const is_thick = found.of_viscosity > 1.2 * found.of_stress && found.of_viscosity > 0.15 * found.of_weight;
  if (!is_thick || !(found.of_weight > 0)) return "";
  return detail::formatted(
      "scree: warning: the artificial viscosity takes %.2g times as much energy from the flow as the stress of the "
      "material: a viscosity_speed of %.4g m/s makes it thicker than the material itself; take a smaller one, or "
      "`using viscosity = ResidualViscosity` in the models (docs/choosing.md, artificial viscosity)",
      found.of_viscosity / found.of_stress, speed);
}

}  // namespace scree

#ifdef SCREE_COMPILED
#define SCREE_INSTANCES(P)                                                                                         \
  SCREE_INSTANCE scree::ViscousPower scree::viscous_power(scree::WholeBody<scree::AnyParticles<P>> const&, double, \
                                                          double, double)
SCREE_FOR_DEFAULT_BASES(SCREE_INSTANCES);
#undef SCREE_INSTANCES
#endif
