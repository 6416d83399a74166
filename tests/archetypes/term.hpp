// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/fields/standard.hpp>
#include <scree/pairs/term.hpp>

namespace scree::test::archetypes {

/// sum_j V_j (C_j - C_i) W_ij.
struct Term {
  using reads = Fields<Volume, Concentration>;
  using adds = Fields<ConcentrationRate>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    sum[concentration_rate] += j[volume] * (j[concentration] - i[concentration]) * ij.W();
  }
};

}  // namespace scree::test::archetypes
