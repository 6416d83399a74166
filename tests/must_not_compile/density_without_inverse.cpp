// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: a density for terms needs a list `reads`, of\(i\) and inverse_of
#include <scree/terms/stress_divergence.hpp>

struct Rho {
  using reads = scree::Fields<>;
  template <class I>
  SCREE_FN double of(I const&) const {
    return 1000;
  }
#ifdef FIXED
  template <class I>
  SCREE_FN double inverse_of(I const&) const {
    return 1e-3;
  }
#endif
};

scree::StressDivergence<Rho> const term{};
