// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `filter` is not a StressFilter
#include <scree/granular/granular.hpp>

struct Filter {
  using history = scree::Fields<>;
#ifdef FIXED
  int period = 10;  // steps
#endif
  std::tuple<> passes() const { return {}; }
};
struct Models : scree::GranularModels {
  using filter = Filter;
};

auto limits(scree::Granular<Models> const& physics) { return physics.limits({}); }
