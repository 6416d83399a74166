// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: but no field in its `history` names a rate
#include <scree/granular/granular.hpp>

struct Damage : scree::Scalar<"damage", "1"> {
#ifdef FIXED
  struct Rate : scree::Scalar<"damage rate", "1/s"> {};
  using rate = Rate;
#endif
};
struct Law : scree::Elastic {
  using history = scree::Fields<Damage>;
  template <class Real, class Point, class Rates>
  SCREE_FN void history_rate(scree::StressTensor<Real> const&, scree::Mat<3, Real> const&, Point const&, Rates&) const {
  }
};
struct Models : scree::GranularModels {
  using law = Law;
};

scree::Granular<Models> const physics{};
