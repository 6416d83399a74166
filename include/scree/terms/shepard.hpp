// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/standard.hpp"
#include "../pairs/term.hpp"

namespace scree {

/// The weighted sum $\sum_j X_j V_j W_{ij}$ of a field.
template <Field F>
struct WeightedSum : Labelled<"weighted sum", "as the field"> {
  template <int Dim, class Real>
  using value = typename F::template value<Dim, Real>;
};
/// The sum of the weights, $\sum_j V_j W_{ij}$.
struct Weight : Scalar<"weight", "1"> {};

namespace fields {
inline constexpr Weight weight{};
}  // namespace fields

/// The smoothed value of a field, stored separately because neighbours still read the old value of the field.
template <Field F>
struct Smoothed : Labelled<"smoothed field", "as the field"> {
  template <int Dim, class Real>
  using value = typename F::template value<Dim, Real>;
};

/// The two sums of a Shepard mean, including the particle itself.
template <Field F>
struct ShepardSums {
  using reads = Fields<Volume, F>;
  using adds = Fields<WeightedSum<F>, Weight>;
  static constexpr bool takes_packs = true;
  static constexpr bool includes_self = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    auto const w = j[volume] * ij.W();
    sum[WeightedSum<F>{}] += j[F{}] * w;
    sum[weight] += w;
  }
};

/// The Shepard mean $X_i = \sum_j X_j V_j W_{ij} / \sum_j V_j W_{ij}$ (Zhu et al. 2024, eq. 3.12), which is exact for
/// constants on any set of neighbours.
template <Field F>
struct ShepardMean {
  using reads = Fields<>;
  using writes = Fields<Smoothed<F>>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    out[Smoothed<F>{}] = total[WeightedSum<F>{}] / total[fields::weight];
  }
};

}  // namespace scree
