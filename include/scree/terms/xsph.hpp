// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "density.hpp"

// XSPH (Monaghan 1989): particles move with a velocity between their own and the mean velocity of their neighbours,
// which keeps them ordered, while the momentum equation uses their own velocity. A physics model with XSPH lists
// Evolves<Position, TransportVelocity> instead of Position (fields/rate.hpp) and adds the pass
//   pair_pass_then<Material>(label, MixVelocity{epsilon}, over<Material>(MeanVelocityDifference<>{rho}))
// In a staggered integrator, this pass is the stage after the stage of the velocity.
namespace scree {

/// The velocity with which a particle moves, m/s.
struct TransportVelocity : Vector<"transport velocity", "m/s"> {};

/// The mean velocity difference $\sum_j m_j/\rho_{ij} (u_j - u_i) W_{ij}$, with the mean density $\rho_{ij}$ of the two
/// particles.
struct VelocityDifference : Vector<"mean velocity difference", "m/s"> {};

namespace fields {
inline constexpr TransportVelocity transport_velocity{};
inline constexpr VelocityDifference velocity_difference{};
}  // namespace fields

/// The sum for the mean velocity difference between a particle and its neighbours.
template <class Rho = UniformDensity>
struct MeanVelocityDifference {
  static_assert(detail::explain_density<Rho>());
  Rho rho;
  using reads = Merge<Fields<Volume, Velocity>, typename Rho::reads>;
  using adds = Fields<VelocityDifference>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    auto const rho_i = rho.of(i), rho_j = rho.of(j);
    sum[velocity_difference] += (2 * rho_j / (rho_i + rho_j) * j[volume] * ij.W()) * (j[velocity] - i[velocity]);
  }
};

/// The transport velocity $u_i + \epsilon \sum_j m_j/\rho_{ij} (u_j - u_i) W_{ij}$. The sum is antisymmetric, so the
/// total of m u is the same as with the particles' own velocities.
struct MixVelocity {
  double epsilon = 0.5;  ///< 0: own velocity, 1: mean velocity of the neighbours
  using reads = Fields<Velocity>;
  using writes = Fields<TransportVelocity>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& i, T const& total, O& out) const {
    using namespace fields;
    using vector = std::remove_cvref_t<decltype(i[velocity])>;
    out[transport_velocity] = i[velocity] + typename vector::Scalar(epsilon) * total[velocity_difference];
  }
};

}  // namespace scree
