// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `projections` of `physics` must be a function projections
#include <scree/solver/solver.hpp>

struct NothingHappens {
  using evolves = scree::Fields<scree::Concentration>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
#ifdef FIXED
  std::tuple<> projections(scree::Resolution const&) const { return {}; }
#else
  std::tuple<> projections(scree::Resolution const&) { return {}; }
#endif
};

struct Case : scree::Formulation<2> {
  using physics = NothingHappens;
};

double run(scree::Solver<Case>& solver) { return solver.step(1); }
