// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: a field in `history` of this law names a rate: the law needs history_rate\(sigma, L, point, rates\)
#include <scree/granular/granular.hpp>

struct DamageRate : scree::Scalar<"damage rate", "1/s"> {};
struct Damage : scree::Scalar<"damage", "1"> {
  using rate = DamageRate;
};

struct Brittle : scree::Elastic {
  using history = scree::Fields<Damage>;
#ifdef FIXED
  template <class Real, class Point, class Rates>
  SCREE_FN void history_rate(scree::StressTensor<Real> const&, scree::Mat<3, Real> const& L, Point const&,
                             Rates& rates) const {
    rates[DamageRate{}] = scree::trace(L);
  }
#endif
};

struct Models : scree::GranularModels {
  using law = Brittle;
};

auto limits(scree::Granular<Models> const& physics) { return physics.limits({}); }
