// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/laws/mu_of_i.hpp>

namespace scree::test::archetypes {

struct OneMillimetre {
  using reads = Fields<>;
  template <class Point>
  SCREE_FN double mean_diameter(Point const&) const {
    return 1e-3;
  }
};
static_assert(GrainSizes<OneMillimetre> && ConstitutiveLaw<MuOfI<OneMillimetre>>);

}  // namespace scree::test::archetypes
