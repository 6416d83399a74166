// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `diagnostics` needs a function passes
#include <scree/solver/solver.hpp>

struct NothingHappens {
  using evolves = scree::Fields<scree::Concentration>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
};

struct Output {
#ifdef FIXED
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
#else
  std::tuple<> pass(scree::Resolution const&) const { return {}; }
#endif
};

struct Case : scree::Formulation<2> {
  using physics = NothingHappens;
  using diagnostics = Output;
};

double run(scree::Solver<Case>& solver) { return solver.step(1); }
