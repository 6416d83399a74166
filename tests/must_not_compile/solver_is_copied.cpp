// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: a copy would share the fields
// not brief: a function that is deleted gets its sentence in the note on where it is declared, not in the error
#include <scree/solver/solver.hpp>

struct NothingHappens {
  using evolves = scree::Fields<scree::Concentration>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
};

struct Case : scree::Formulation<2> {
  using physics = NothingHappens;
};

double run(scree::Solver<Case>& solver) {
#ifdef FIXED
  scree::Solver<Case> other = std::move(solver);
#else
  scree::Solver<Case> other = solver;
#endif
  return other.time();
}
