// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: but is not ListsWithSkin: it also needs reach
#include <scree/neighbours/brute_force.hpp>
#include <scree/solver/solver.hpp>

struct NothingHappens {
  using evolves = scree::Fields<scree::Concentration>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
};

template <class P>
struct Everything : scree::BruteForce<P> {
  using scree::BruteForce<P>::BruteForce;
#ifndef FIXED
  static constexpr double skin = 0.1;
#endif
};

struct Case : scree::Formulation<2> {
  using physics = NothingHappens;
  template <class P>
  using search = Everything<P>;
};

double run(scree::Solver<Case>& solver) { return solver.step(1); }
