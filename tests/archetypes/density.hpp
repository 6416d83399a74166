// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/terms/stress_divergence.hpp>

namespace scree::test::archetypes {

struct Water {
  using reads = Fields<>;
  template <class I>
  SCREE_FN double of(I const&) const {
    return 1000;
  }
  template <class I>
  SCREE_FN double inverse_of(I const&) const {
    return 1e-3;
  }
};
static_assert(DensityOf<Water>);
inline StressDivergence<Water> const divergence{};

}  // namespace scree::test::archetypes
