// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: this model reads a field that it does not declare in `reads`
#include <scree/fields/standard.hpp>
#include <scree/pairs/term.hpp>

struct Sum {
#ifdef FIXED
  using reads = scree::Fields<scree::Mass, scree::Volume>;
#else
  using reads = scree::Fields<scree::Mass>;
#endif
  using adds = scree::Fields<scree::Density>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    using namespace scree::fields;
    sum[density] += j[mass] / j[volume] * ij.W();
  }
};

#include "run_term.hpp"
