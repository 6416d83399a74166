// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/mixing/kinds.hpp>

namespace scree::test::archetypes {

/// One kind in each particle.
struct OneKindEach {
  static constexpr int kinds = 2;
  using reads = Fields<>;
  template <class I>
  SCREE_FN Vec<2, double> operator()(I const&) const {
    return {1, 0};
  }
};

}  // namespace scree::test::archetypes
