// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: is not a TimeIntegrator: it needs static double advance
#include <scree/solver/solver.hpp>

struct NothingHappens {
  using evolves = scree::Fields<scree::Concentration>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
};

struct Waiting {
  template <class Evolved>
  using fields = scree::evolved_fields<Evolved>;
#ifdef FIXED
  template <class Solver>
  static double advance(Solver& solver, double longest) {
    solver.update_rates();
    return solver.choose_step(longest);
  }
#endif
};

struct Case : scree::Formulation<2> {
  using physics = NothingHappens;
  using integrator = Waiting;
};

double run(scree::Solver<Case>& solver) { return solver.step(1); }
