// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: filters of `physics` are two functions
#include <scree/solver/solver.hpp>

struct NothingHappens {
  using evolves = scree::Fields<scree::Concentration>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
#ifdef FIXED
  std::tuple<> filters(scree::Resolution const&) const { return {}; }
  int filter_period() const { return 2; }
#else
  std::tuple<> filters(scree::Resolution const&) const { return {}; }
#endif
};

struct Case : scree::Formulation<2> {
  using physics = NothingHappens;
};

double run(scree::Solver<Case>& solver) { return solver.step(1); }
