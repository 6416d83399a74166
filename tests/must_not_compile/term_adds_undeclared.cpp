// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: this term adds to a field that it does not declare in `adds`
#include <scree/fields/standard.hpp>
#include <scree/pairs/term.hpp>

struct Sum {
  using reads = scree::Fields<scree::Mass>;
#ifdef FIXED
  using adds = scree::Fields<scree::Density, scree::Volume>;
#else
  using adds = scree::Fields<scree::Density>;
#endif
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    using namespace scree::fields;
    sum[density] += j[mass] * ij.W();
    sum[volume] += ij.r;
  }
};

#include "run_term.hpp"
