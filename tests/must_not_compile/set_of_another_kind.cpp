// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: returns another kind of value than the field has
#include <scree/solver/solver.hpp>

struct NothingHappens {
  using evolves = scree::Fields<scree::Velocity>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
};

struct Case : scree::Formulation<2> {
  using physics = NothingHappens;
};

void start(scree::Solver<Case>& solver) {
  using namespace scree::fields;
#ifdef FIXED
  solver.set(velocity, [](scree::Vec<2, double> const& x) { return scree::Vec<2, double>(x[1], 0); });
#else
  solver.set(velocity, [](scree::Vec<2, double> const& x) { return x[1]; });
#endif
}
