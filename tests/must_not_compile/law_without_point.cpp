// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: this law needs stress_rate\(sigma, L, point\)
#include <scree/granular/granular.hpp>

struct Stiff : scree::Elastic {
#ifndef FIXED
  template <class Real>
  SCREE_FN scree::StressTensor<Real> stress_rate(scree::StressTensor<Real> const&, scree::Mat<3, Real> const& L) const {
    return L + scree::transposed(L);
  }
#endif
};

struct Models : scree::GranularModels {
  using law = Stiff;
};

auto limits(scree::Granular<Models> const& physics) { return physics.limits({}); }
