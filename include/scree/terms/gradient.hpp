// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/standard.hpp"
#include "../pairs/term.hpp"

namespace scree {

/// The gradient of a scalar field.
template <Field F>
struct Gradient : Labelled<"gradient", "per m"> {
  template <int Dim, class Real>
  using value = Vec<Dim, Real>;
};

namespace fields {
template <Field F>
inline constexpr Gradient<F> gradient{};
}  // namespace fields

/// The plain gradient $\nabla X_i = \sum_j V_j (X_j - X_i) \nabla W_{ij}$, which is exact for constants and of second
/// order if the support is full.
template <Field F>
struct PlainGradient {
  using reads = Fields<Volume, F>;
  using adds = Fields<Gradient<F>>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    sum[gradient<F>] += j[volume] * (j[F{}] - i[F{}]) * ij.gradW();
  }
};

}  // namespace scree
