// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: this is not a SegregationClosure: it needs lists
#include <scree/segregation/conservative.hpp>

struct Percolation {
  using reads = scree::Fields<>;
#ifdef FIXED
  using writes = scree::Fields<scree::SegregationVelocity, scree::Diffusivity>;
#else
  using writes = scree::Fields<scree::SegregationVelocity>;
#endif
  template <class I, class O>
  SCREE_FN void operator()(I const&, O& out) const {
    out[scree::fields::segregation_velocity] = 1;
  }
};

scree::ConservativeSegregation<Percolation> const physics{};
