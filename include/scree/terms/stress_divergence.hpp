// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/root.hpp"
#include "density.hpp"

namespace scree {

/// The acceleration $du_i/dt = \sum_j m_j (\sigma_i/\rho_i^2 + \sigma_j/\rho_j^2) \cdot \nabla W_{ij}$ with m = rho V
/// (Zhu et al. 2024, eq. 3.9). The stress term is symmetric in i and j, so momentum is conserved.
template <class Rho = UniformDensity>
struct StressDivergence {
  static_assert(detail::explain_density<Rho>());
  Rho rho;
  using reads = Merge<Fields<Volume, Stress>, typename Rho::reads>;
  using adds = Fields<Acceleration>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    auto const both = sq(rho.inverse_of(i)) * i[stress] + sq(rho.inverse_of(j)) * j[stress];
    sum[acceleration] += (rho.of(j) * j[volume] * ij.slope()) * product(both, ij.x);
  }
};

/// The acceleration $du_i/dt = (1/\rho_i) \sum_j V_j (\sigma_i + \sigma_j) \cdot \nabla W_{ij}$, for materials of
/// different densities. These forces do the same work as the stress does on the plain velocity gradient, so a jump in
/// density adds no energy. With uniform density, this form equals StressDivergence. Momentum is conserved.
template <class Rho>
struct InterfaceStressDivergence {
  static_assert(detail::explain_density<Rho>());
  Rho rho;  ///< density of i
  using reads = Fields<Volume, Stress>;
  using reads_i = typename Rho::reads;
  using adds = Fields<Acceleration>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    sum[acceleration] += (rho.inverse_of(i) * j[volume] * ij.slope()) * product(i[stress] + j[stress], ij.x);
  }
};

}  // namespace scree
