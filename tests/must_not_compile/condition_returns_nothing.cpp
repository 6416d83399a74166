// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the condition of this pass needs a list `reads` and operator
#include <scree/passes/run_passes.hpp>

#include <scree/terms/shepard.hpp>

struct Heavy {
  using reads = scree::Fields<scree::Mass>;
#ifdef FIXED
  template <class I>
  SCREE_FN bool operator()(I const& i) const {
    return i[scree::fields::mass] > 1;
  }
#else
  template <class I>
  SCREE_FN void operator()(I const&) const {}
#endif
};
auto passes_of_case() {
  return std::tuple(
      scree::pair_pass_where<scree::Material>("mean", Heavy{}, scree::ShepardMean<scree::Density>{},
                                              scree::over<scree::Material>(scree::ShepardSums<scree::Density>{})));
}

#include "run_passes.hpp"
