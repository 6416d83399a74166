// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "density.hpp"

// The continuity equation for formulations that evolve density, and the volume that follows from the density.
namespace scree {

/// The continuity equation $d(\rho_i)/dt = \rho_i \sum_j V_j (u_i - u_j) \cdot \nabla W_{ij} = -\rho_i
/// \operatorname{tr}(L_i)$ with the plain velocity gradient L (Zhu et al. 2024, eq. 2.3). The sum is the rate of change
/// of $\sum_j V_j W_{ij}$ at constant volumes, so density and number density stay consistent.
struct Continuity {
  using reads = Fields<Volume, Velocity>;
  using reads_i = Fields<Density>;
  using adds = Fields<DensityRate>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    sum[density_rate] += i[density] * (j[volume] * ij.slope() * dot(i[velocity] - j[velocity], ij.x));
  }
};

/// The volume V = m/rho, from a point pass that must run before passes that use the volume.
struct VolumeOfDensity {
  using reads = Fields<Mass, Density>;
  using writes = Fields<Volume>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    out[volume] = i[mass] / i[density];
  }
};

}  // namespace scree
