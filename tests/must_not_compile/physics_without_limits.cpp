// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `physics` needs a function `limits\(resolution\)`
#include <scree/solver/solver.hpp>

#include <tuple>

struct NothingHappens {
  using evolves = scree::Fields<scree::Concentration>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
#ifdef FIXED
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
#endif
};

struct Case : scree::Formulation<2> {
  using physics = NothingHappens;
};

double run(scree::Solver<Case>& solver) { return solver.step(1); }
