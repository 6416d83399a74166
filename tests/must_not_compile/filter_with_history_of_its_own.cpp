// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: history \(Fields<> or Fields<Yielding>\)
#include <scree/granular/granular.hpp>

struct Filter {
#ifdef FIXED
  using history = scree::Fields<scree::Yielding>;
#else
  using history = scree::Fields<scree::Concentration>;  // nobody would add it up
#endif
  int period = 10;  // steps
  std::tuple<> passes() const { return {}; }
};
struct Models : scree::GranularModels {
  using filter = Filter;
};

auto limits(scree::Granular<Models> const& physics) { return physics.limits({}); }
