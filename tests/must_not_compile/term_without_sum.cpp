// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: this is not a PairTerm: it needs lists
#include <scree/passes/run_passes.hpp>

struct Sum {
  using reads = scree::Fields<scree::Mass>;
  using adds = scree::Fields<scree::Density>;
#ifdef FIXED
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    using namespace scree::fields;
    sum[density] += j[mass] * ij.W();
  }
#endif
};
auto passes_of_case() {
  return std::tuple(scree::pair_pass<scree::Material>("sum", scree::over<scree::Material>(Sum{})));
}

#include "run_passes.hpp"
