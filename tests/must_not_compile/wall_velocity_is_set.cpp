// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the motion gives this field of a wall
#include <scree/solver/solver.hpp>

struct NothingHappens {
  using evolves = scree::Fields<scree::Concentration>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
};

struct Case : scree::Formulation<2> {
  using physics = NothingHappens;
  using carries = scree::Fields<scree::Velocity>;
};

void start(scree::Solver<Case>& solver) {
  using namespace scree::fields;
#ifdef FIXED
  auto const field = rest_position;
#else
  auto const field = velocity;
#endif
  solver.set<scree::Wall>(field, [](scree::Vec<2, double> const& x) { return x; });
}
