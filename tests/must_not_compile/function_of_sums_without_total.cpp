// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the function of the sums of this pass needs lists
#include <scree/passes/run_passes.hpp>

#include <scree/terms/shepard.hpp>

struct Mean {
  using reads = scree::Fields<>;
  using writes = scree::Fields<scree::Smoothed<scree::Density>>;
#ifdef FIXED
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    out[scree::Smoothed<scree::Density>{}] = total[scree::fields::weight];
  }
#else
  template <class I, class O>
  SCREE_FN void operator()(I const&, O& out) const {
    out[scree::Smoothed<scree::Density>{}] = 0;
  }
#endif
};
auto passes_of_case() {
  return std::tuple(scree::pair_pass_then<scree::Material>(
      "mean", Mean{}, scree::over<scree::Material>(scree::ShepardSums<scree::Density>{})));
}

#include "run_passes.hpp"
