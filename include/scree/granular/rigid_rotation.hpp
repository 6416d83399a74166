// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/axial.hpp"
#include "../core/setting.hpp"
#include "../kernels/default_bases.hpp"
#include "../passes/sums.hpp"
#include "../terms/antisymmetric_stress.hpp"
#include "../terms/velocity_gradient.hpp"

#include <cmath>
#include <string>

// Material that turns as a rigid body: the plain velocity gradient finds strain in it.
namespace scree {
namespace granular {

/// The volume and the moments of position and velocity of the particles, for their centre.
template <int Dim>
struct CentreSums {
  static constexpr int count = 1 + 2 * Dim;
  using reads = Fields<Volume, Position, Velocity>;
  template <class I>
  SCREE_FN Vec<count, double> operator()(I const& i) const {
    using namespace fields;
    double const V = double(i[volume]);
    Vec<count, double> sums;
    sums[0] = V;
    for (int a = 0; a < Dim; ++a)
      sums[1 + a] = V * double(i[position][a]), sums[1 + Dim + a] = V * double(i[velocity][a]);
    return sums;
  }
};
/// Twice the kinetic energy over the density, the shear rate, and the moments of position and velocity, about a centre.
template <int Dim>
struct RotationSums {
  static constexpr int moments = 2, count = moments + 2 * Dim * Dim;
  using reads = Fields<Volume, Position, Velocity, ShearRate>;
  Vec<Dim, double> centre;    // m
  Vec<Dim, double> velocity;  // of the centre, m/s
  template <class I>
  SCREE_FN Vec<count, double> operator()(I const& i) const {
    double const V = double(i[fields::volume]);
    Vec<Dim, double> x, u;
    for (int a = 0; a < Dim; ++a) {
      x[a] = double(i[fields::position][a]) - centre[a];
      u[a] = double(i[fields::velocity][a]) - velocity[a];
    }
    Vec<count, double> sums;
    sums[0] = V * squared_norm(u), sums[1] = V * double(i[fields::shear_rate]);
    for (int a = 0; a < Dim; ++a)
      for (int b = 0; b < Dim; ++b) {
        sums[moments + Dim * a + b] = V * x[a] * x[b];
        sums[moments + Dim * (Dim + a) + b] = V * u[a] * x[b];
      }
    return sums;
  }
};

}  // namespace granular

/// The rotation of a body as a whole, which has its angular momentum.
struct RigidRotation {
  double rate = 0;    ///< rad/s
  double share = 0;   ///< of the kinetic energy about the centre, 0 to 1
  double strain = 0;  ///< mean shear rate of the particles over `rate`, -
};
/// The rotation of a body (WholeBody) whose particles have Volume, Position, Velocity and ShearRate; zeros if it does
/// not turn. It runs on the device.
template <class... Of>
[[gnu::cold]] RigidRotation rigid_rotation(WholeBody<Of...> const& body) {
  constexpr int dim = WholeBody<Of...>::policy::dim;
  using Sums = granular::RotationSums<dim>;
  char const* const what = "the rotation of the material";
  auto const of_centre = sums_over(body, granular::CentreSums<dim>{}, what);
  double const V = of_centre[0];
  if (!(V > 0)) return {};
  Sums about;
  for (int a = 0; a < dim; ++a) about.centre[a] = of_centre[1 + a] / V, about.velocity[a] = of_centre[1 + dim + a] / V;
  auto const sums = sums_over(body, about, what);
  Mat<dim, double> xx, ux;
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b) {
      xx(a, b) = sums[Sums::moments + dim * a + b];
      ux(a, b) = sums[Sums::moments + dim * (dim + a) + b];
    }
  double const energy = sums[0];
  auto const momentum = twice_axial<dim, double>(ux);
  auto const turn = over_inertia<dim, double>(momentum, -xx);
  double const rate = norm(turn);
  if (!(rate > 0 && energy > 0)) return {};
  return {rate, dot(turn, momentum) / energy, sums[1] / V / rate};
}
/// The warning of a strain that is not zero in a rotation for material that turns as a rigid body at a time (s); empty
/// for others, and until it could have turned by half a radian at that rate.
[[gnu::cold]] inline std::string warning_of_rotation(RigidRotation const& found, double time) {
  double const angle = found.rate * time;
  if (!(found.share > 0.9 && found.strain < 0.25 && angle > 0.5)) return "";
  return detail::formatted(
      "scree: warning: the material turns as a rigid body, at %.3g rad/s, which makes %.2g rad since the start, and "
      "its "
      "strain (PlainStrain, the default) makes stress of a rotation, more with each turn: `using strain = "
      "ObjectiveStrain` in the models does not (docs/choosing.md, strain)",
      found.rate, angle);
}

}  // namespace scree

#ifdef SCREE_COMPILED
#define SCREE_INSTANCES(P) \
  SCREE_INSTANCE scree::RigidRotation scree::rigid_rotation(scree::WholeBody<scree::AnyParticles<P>> const&)
SCREE_FOR_DEFAULT_BASES(SCREE_INSTANCES);
#undef SCREE_INSTANCES
#endif
