// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "density.hpp"

namespace scree {

/// du_i/dt = sum_j m_j (sigma_i/rho_i^2 + sigma_j/rho_j^2) . gradW_ij, m = rho V: Zhu et al. (2024), eq. 3.9. Symmetric
/// in i and j, so that momentum is conserved.
template <class Rho = UniformDensity>
struct StressDivergence {
  Rho rho;
  using reads = Merge<Fields<Volume, Stress>, typename Rho::reads>;
  using adds = Fields<Acceleration>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    auto const both = sq(rho.inverse_of(i)) * i[stress] + sq(rho.inverse_of(j)) * j[stress];
    sum[acceleration] += (rho.of(j) * j[volume] * ij.slope()) * product(both, ij.x);
  }
};

}  // namespace scree
