// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: this is not a PointFunction: it needs lists
#include <scree/passes/run_passes.hpp>

struct Half {
  using reads = scree::Fields<scree::Density>;
#ifdef FIXED
  using writes = scree::Fields<scree::Mass>;
#endif
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace scree::fields;
    out[mass] = i[density] / 2;
  }
};
auto passes_of_case() { return std::tuple(scree::point_pass<scree::Material>("half", Half{})); }

#include "run_passes.hpp"
