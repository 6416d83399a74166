// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: it needs a constructor from a radius, update\(targets, sources\)
#include <scree/neighbours/brute_force.hpp>
#include <scree/solver/solver.hpp>

struct NothingHappens {
  using evolves = scree::Fields<scree::Concentration>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
};

template <class P>
struct Everything {
  using View = typename scree::BruteForce<P>::View;
  explicit Everything(double) {}
  void update(scree::Positions<P> const&, scree::Positions<P> const&) {}
  View view() const { return {}; }
#ifdef FIXED
  long builds() const { return 0; }
#endif
};

struct Case : scree::Formulation<2> {
  using physics = NothingHappens;
  template <class P>
  using search = Everything<P>;
};

double run(scree::Solver<Case>& solver) { return solver.step(1); }
