// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/root.hpp"
#include "density.hpp"

namespace scree {

/// du_i/dt = sum_j m_j (sigma_i/rho_i^2 + sigma_j/rho_j^2) . gradW_ij, m = rho V: Zhu et al. (2024), eq. 3.9. Symmetric
/// in i and j, so that momentum is conserved.
template <class Rho = UniformDensity>
struct StressDivergence {
  static_assert(detail::explain_density<Rho>());
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

/// du_i/dt = 2/rho_i sum_j V_j (rho_j sigma_i + rho_i sigma_j)/(rho_i + rho_j) . gradW_ij, for materials of different
/// densities: the stress between two particles is the one at which both accelerate alike, as the pressure of Hu & Adams
/// (2007), so that a hydrostatic stress is in equilibrium across an interface. With uniform density it equals the form
/// above. Momentum is conserved.
template <class Rho>
struct InterfaceStressDivergence {
  static_assert(detail::explain_density<Rho>());
  Rho rho;
  using reads = Merge<Fields<Volume, Stress>, typename Rho::reads>;
  using adds = Fields<Acceleration>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using Real = typename IJ::real;
    Real const rho_i = rho.of(i), rho_j = rho.of(j);
    auto const both = rho_j * i[stress] + rho_i * j[stress];
    sum[acceleration] += (2 * j[volume] * quotient(ij.slope(), rho_i * (rho_i + rho_j))) * product(both, ij.x);
  }
};

}  // namespace scree
