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

// Detection of material that rotates as a rigid body, in which the plain velocity gradient contains spurious strain.
namespace scree {
namespace granular {

/// Computes the contributions of a particle to the volume-weighted sums of 1, squared speed, shear rate, position and
/// velocity, and the products of position and velocity with the position, all relative to a moving centre.
template <int Dim>
struct RotationSums {
  static constexpr int first = 3, second = first + 2 * Dim, count = second + 2 * Dim * Dim;
  using reads = Fields<Volume, Position, Velocity, ShearRate>;
  Vec<2 * Dim, double> centre;  // position (m) and velocity (m/s) of the centre
  template <class I>
  SCREE_FN Vec<count, double> operator()(I const& i) const {
    double const V = double(i[fields::volume]);
    Vec<2 * Dim, double> xu;
    for (int a = 0; a < Dim; ++a) {
      xu[a] = double(i[fields::position][a]) - centre[a];
      xu[Dim + a] = double(i[fields::velocity][a]) - centre[Dim + a];
    }
    Vec<count, double> sums;
    sums[0] = V, sums[1] = 0, sums[2] = V * double(i[fields::shear_rate]);
    for (int a = 0; a < 2 * Dim; ++a) {
      if (a >= Dim) sums[1] += V * xu[a] * xu[a];
      sums[first + a] = V * xu[a];
      for (int b = 0; b < Dim; ++b) sums[second + Dim * a + b] = V * xu[a] * xu[b];
    }
    return sums;
  }
};

}  // namespace granular

/// The rigid rotation with the same angular momentum as a body.
struct RigidRotation {
  double rate = 0;    ///< rad/s
  double share = 0;   ///< share of the kinetic energy about the centre, 0 to 1
  double strain = 0;  ///< mean shear rate of the particles over `rate`, -
};
/// Returns the rotation of a body (WholeBody) whose particles have Volume, Position, Velocity and ShearRate; zeros if
/// the body does not rotate. The sums are computed on the device.
template <class... Of>
[[gnu::cold]] RigidRotation rigid_rotation(WholeBody<Of...> const& body) {
  constexpr int dim = WholeBody<Of...>::policy::dim;
  using Sums = granular::RotationSums<dim>;
  // The first pass computes the centre; the sums of the second pass are relative to this centre, which reduces rounding
  // errors.
  Sums about{zero<Vec<2 * dim, double>>()};
  auto sums = zero<Vec<Sums::count, double>>();
  for (int pass = 0; pass < 2; ++pass) {
    for (int a = 0; pass > 0 && a < 2 * dim; ++a) about.centre[a] = sums[Sums::first + a] / sums[0];
    sums = sums_over(body, about, "the rotation of the material");
    if (!(sums[0] > 0)) return {};
  }
  auto const* const first = &sums[Sums::first];
  auto const second = [&](int a, int b) { return sums[Sums::second + dim * a + b] - first[a] * first[b] / sums[0]; };
  Mat<dim, double> xx, ux;
  double energy = sums[1];
  for (int a = 0; a < dim; ++a) {
    energy -= sq(first[dim + a]) / sums[0];
    for (int b = 0; b < dim; ++b) xx(a, b) = second(a, b), ux(a, b) = second(dim + a, b);
  }
  auto const momentum = twice_axial<dim, double>(ux);
  auto const turn = over_inertia<dim, double>(momentum, -xx);
  double const rate = norm(turn);
  if (!(rate > 0 && energy > 0)) return {};
  return {rate, dot(turn, momentum) / energy, sums[2] / sums[0] / rate};
}
/// Returns the warning that the strain is not zero in a rotation, for material that rotates as a rigid body at a time
/// (s); empty for other motions, and while rate times time is at most half a radian.
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
