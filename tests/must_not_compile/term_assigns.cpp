// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: no match for .*operator=|no viable overloaded '='|no operator "=" matches
#include <scree/fields/record.hpp>
#include <scree/fields/standard.hpp>
#include <scree/pairs/term.hpp>

// A sum offers += only; assigning would throw away what other neighbours and other terms have added.
struct Sum {
  using reads = scree::Fields<scree::Mass>;
  using adds = scree::Fields<scree::Density>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    using namespace scree::fields;
#ifdef FIXED
    sum[density] += j[mass] * ij.W();
#else
    sum[density] = j[mass] * ij.W();
#endif
  }
};

#include "run_term.hpp"
