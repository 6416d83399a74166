// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: returns a tuple of what limit\(\) returns
#include <scree/solver/solver.hpp>

struct NothingHappens {
  using evolves = scree::Fields<scree::Concentration>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
#ifdef FIXED
  auto limits(scree::Resolution const&) const { return std::tuple(scree::limit("shortest", 0.1)); }
#else
  auto limits(scree::Resolution const&) const { return std::tuple(0.1); }
#endif
};

struct Case : scree::Formulation<2> {
  using physics = NothingHappens;
};

double run(scree::Solver<Case>& solver) { return solver.step(1); }
