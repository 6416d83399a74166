// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the points have another dimension or precision than the formulation
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

struct NothingHappens {
  using evolves = scree::Fields<scree::Concentration>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
};

struct Case : scree::Formulation<2, float> {
  using physics = NothingHappens;
};

double run(std::vector<scree::Vec<2, double>> const& points) {
#ifdef FIXED
  scree::Solver<Case> const solver({.spacing = 0.1}, scree::cast<float>(points));
#else
  scree::Solver<Case> const solver({.spacing = 0.1}, points);
#endif
  return solver.time();
}
