// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/principal.hpp"
#include "density.hpp"

// The artificial stress of Gray, Monaghan & Swift (2001) against the tensile instability, for tension-positive stress.
namespace scree {

/// The artificial stress $R_i = -\epsilon \sigma_i^+/\rho_i^2$ with $\sigma^+$, the part of the stress with positive
/// principal values.
struct ArtificialStress : Symmetric3<"artificial stress", "m^5/(kg s^2)"> {};

namespace fields {
inline constexpr ArtificialStress artificial_stress{};
}  // namespace fields

/// The artificial stress of a particle, from a point pass that runs before the sum over neighbours. In 2D, tension out
/// of the plane is excluded.
template <class Rho = UniformDensity>
struct ArtificialStressOf {
  static_assert(detail::explain_density<Rho>());
  Rho rho;
  double epsilon = 0.3;  ///< -
  using reads = Merge<Fields<Volume, Stress>, typename Rho::reads>;
  using writes = Fields<ArtificialStress>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    using Packed = std::remove_cvref_t<decltype(i[stress])>;
    using Real = typename Packed::Scalar;
    constexpr int dim = Packed::RowsAtCompileTime == 4 ? 2 : 3;
    auto sigma = unpacked(i[stress]);
    if constexpr (dim == 2) sigma(2, 2) = 0;
    Mat<3, Real> const R = positive_part(sigma) * (Real(-epsilon) / sq(rho.of(i)));
    out[artificial_stress] = packed<dim>(R);
  }
};

/// The acceleration $du_i/dt = \sum_j m_j f^4 (R_i + R_j) \cdot \nabla W_{ij}$ with f = W(r)/W(spacing). The term
/// repels neighbours of a particle in tension that come closer than the spacing, and hardly affects the others.
/// Momentum is conserved.
template <class Rho = UniformDensity>
struct ArtificialStressDivergence {
  static_assert(detail::explain_density<Rho>());
  Rho rho;
  double spacing = 0;  ///< initial distance of the particles, m
  using reads = Merge<Fields<Volume, ArtificialStress>, typename Rho::reads>;
  using adds = Fields<Acceleration>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    using Real = typename IJ::real;
    Real const f = ij.W() / ij.W_at(Real(spacing));
    auto const both = (i[artificial_stress] + j[artificial_stress]).eval();
    sum[acceleration] += (rho.of(j) * j[volume] * math::power<4>(f) * ij.slope()) * product(both, ij.x);
  }
};

}  // namespace scree
