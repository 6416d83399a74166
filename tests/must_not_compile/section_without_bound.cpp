// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `section` is not a YieldSection: it is an empty struct with ratio
#include <scree/granular/granular.hpp>

struct Round {
  template <class Real>
  SCREE_FN Real ratio(Real k, Real) const {
    return k;
  }
#ifdef FIXED
  template <class Real>
  SCREE_FN Real least_ratio(Real k) const {
    return k;
  }
#endif
};
struct Models : scree::GranularModels {
  using section = Round;
};

auto limits(scree::Granular<Models> const& physics) { return physics.limits({}); }
