// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the grains of MuOfI need a list `reads`, and mean_diameter
#include <scree/granular/granular.hpp>

struct Grains {
  using reads = scree::Fields<>;
#ifdef FIXED
  template <class Point>
  SCREE_FN double mean_diameter(Point const&) const {
    return 1e-3;
  }
#endif
};
struct Models : scree::GranularModels {
  using law = scree::MuOfI<Grains>;
};

auto limits(scree::Granular<Models> const& physics) { return physics.limits({}); }
