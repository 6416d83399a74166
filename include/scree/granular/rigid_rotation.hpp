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

/// The sums over the particles from which rigid_rotation() finds the rotation: volume, twice the kinetic energy over
/// the density, the shear rate, and the moments of position and velocity.
template <int Dim>
struct RotationSums {
  static constexpr int first = 3, second = first + 2 * Dim, count = second + 2 * Dim * Dim;
  using reads = Fields<Volume, Position, Velocity, ShearRate>;
  template <class I>
  SCREE_FN Vec<count, double> operator()(I const& i) const {
    using namespace fields;
    double const V = double(i[volume]);
    Vec<Dim, double> x, u;
    for (int a = 0; a < Dim; ++a) x[a] = double(i[position][a]), u[a] = double(i[velocity][a]);
    Vec<count, double> sums;
    sums[0] = V, sums[1] = V * squared_norm(u), sums[2] = V * double(i[shear_rate]);
    for (int a = 0; a < Dim; ++a) {
      sums[first + a] = V * x[a], sums[first + Dim + a] = V * u[a];
      for (int b = 0; b < Dim; ++b) {
        sums[second + Dim * a + b] = V * x[a] * x[b];
        sums[second + Dim * (Dim + a) + b] = V * u[a] * x[b];
      }
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
  auto const sums = sums_over(body, Sums{}, "the rotation of the material");
  double const V = sums[0];
  if (!(V > 0)) return {};
  double const* const first = &sums[Sums::first];
  double const* const second = &sums[Sums::second];
  // about the centre
  Mat<dim, double> xx, ux;
  double energy = sums[1] / V;
  for (int a = 0; a < dim; ++a) {
    double const x = first[a] / V, u = first[dim + a] / V;
    energy -= u * u;
    for (int b = 0; b < dim; ++b) {
      xx(a, b) = second[dim * a + b] / V - x * first[b] / V;
      ux(a, b) = second[dim * (dim + a) + b] / V - u * first[b] / V;
    }
  }
  auto const momentum = twice_axial<dim, double>(ux);
  auto const turn = over_inertia<dim, double>(momentum, -xx);
  double const rate = norm(turn);
  if (!(rate > 0 && energy > 0)) return {};
  return {rate, dot(turn, momentum) / energy, sums[2] / V / rate};
}
/// The warning of a strain that is not zero in a rotation for material that turns as a rigid body at a time (s); empty
/// for others. Until it has turned by half a radian at that rate there is nothing to warn of.
[[gnu::cold]] inline std::string warning_of_rotation(RigidRotation const& found, double time) {
  double const angle = found.rate * time;
  if (!(found.share > 0.9 && found.strain < 0.25 && angle > 0.5)) return "";
  return detail::formatted(
      "scree: warning: the material turns as a rigid body, by %.2g rad at the present %.3g rad/s, and the strain of "
      "its "
      "models (PlainStrain, the default) makes stress of a rotation, which grows with the angle: `using strain = "
      "ObjectiveStrain` in the models does not (docs/choosing.md, strain)",
      angle, found.rate);
}

}  // namespace scree

#ifdef SCREE_COMPILED
#define SCREE_INSTANCES(P) \
  SCREE_INSTANCE scree::RigidRotation scree::rigid_rotation(scree::WholeBody<scree::AnyParticles<P>> const&)
SCREE_FOR_DEFAULT_BASES(SCREE_INSTANCES);
#undef SCREE_INSTANCES
#endif
