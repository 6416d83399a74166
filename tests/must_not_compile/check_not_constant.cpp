// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `check` of this class cannot be called for a constant value
#include <scree/solver/solver.hpp>

struct NothingHappens {
  using evolves = scree::Fields<scree::Concentration>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
#ifdef FIXED
  void check() const {}
#else
  void check() {}
#endif
};

struct Case : scree::Formulation<2> {
  using physics = NothingHappens;
};

double run(scree::Solver<Case>& solver) { return solver.step(1); }
