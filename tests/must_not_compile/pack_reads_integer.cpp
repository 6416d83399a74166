// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: a term that takes packs reads an integer of j
#include <scree/fields/record.hpp>
#include <scree/fields/standard.hpp>
#include <scree/pairs/term.hpp>

// The kind of a neighbour differs between the pairs of a pack.
struct Sum {
#ifdef FIXED
  using reads = scree::Fields<scree::Mass>;
#else
  using reads = scree::Fields<scree::Mass, scree::Identity>;
#endif
  using adds = scree::Fields<scree::Density>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    using namespace scree::fields;
    sum[density] += j[mass] * ij.W();
  }
};

#include "run_term.hpp"
