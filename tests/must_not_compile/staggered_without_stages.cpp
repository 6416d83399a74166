// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: this integrator is staggered: it needs a function `stages\(resolution\)` of the physics
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/solver/solver.hpp>

struct NothingHappens {
  using evolves = scree::Fields<scree::Concentration>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
#ifdef FIXED
  auto stages(scree::Resolution const&) const { return std::tuple(scree::stage<evolves>(std::tuple<>())); }
#endif
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
};

struct Case : scree::Formulation<2> {
  using physics = NothingHappens;
  using integrator = scree::SymplecticEuler;
};

double run(scree::Solver<Case>& solver) { return solver.step(1); }
