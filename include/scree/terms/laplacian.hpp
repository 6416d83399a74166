// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/root.hpp"
#include "../fields/standard.hpp"
#include "../pairs/term.hpp"

namespace scree {

/// The generalised Laplacian div(g grad f) of two scalar fields f and g.
template <Field F, Field G>
struct Laplacian : Labelled<"Laplacian", "per m^2"> {
  template <int Dim, class Real>
  using value = Real;
};

namespace fields {
template <Field F, Field G>
inline constexpr Laplacian<F, G> laplacian{};
}  // namespace fields

/// The term $\operatorname{div}(g \nabla f)_i = \sum_j V_j (g_i + g_j)(f_i - f_j) \, x_{ij} \cdot \nabla W_{ij}/(\lvert
/// x_{ij}\rvert^2 + \eta^2)$ with $\eta = 0.1 h$ (Zhu et al. 2024, eq. 3.8). If all neighbours belong to the material,
/// the sum implies df/dn = 0 at the boundary of the material.
template <Field F, Field G>
struct DoubleSumLaplacian {
  using reads = Fields<Volume, F, G>;
  using adds = Fields<Laplacian<F, G>>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    using namespace math;
    auto const radial = quotient(sq(ij.r) * ij.slope(), sq(ij.r) + sq(ij.h()) / 100);
    sum[laplacian<F, G>] += j[volume] * (i[G{}] + j[G{}]) * (i[F{}] - j[F{}]) * radial;
  }
};

}  // namespace scree
