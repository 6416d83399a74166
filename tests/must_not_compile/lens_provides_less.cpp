// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: this lens has an operator\(\) for a field that is missing in its list `provides`
#include <scree/passes/run_passes.hpp>

#include <scree/terms/shepard.hpp>

struct Lens {
#ifdef FIXED
  using provides = scree::Fields<scree::Volume>;
#else
  using provides = scree::Fields<>;
#endif
  template <class I, class J>
  SCREE_FN double operator()(scree::Volume, I const&, J const&) const {
    return 1;
  }
};
auto passes_of_case() {
  return std::tuple(scree::pair_pass<scree::Material>(
      "sums", scree::over_through<scree::Wall>(Lens{}, scree::ShepardSums<scree::Density>{})));
}

#include "run_passes.hpp"
