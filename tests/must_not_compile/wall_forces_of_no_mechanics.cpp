// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: WallForces needs a function wall_force_passes
#include <scree/granular/granular.hpp>
#include <scree/granular/wall_forces.hpp>
#include <scree/solver/solver.hpp>

struct NothingHappens {
  using evolves = scree::Fields<scree::Concentration>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
};

struct Case : scree::Formulation<2> {
#ifdef FIXED
  using physics = scree::Granular<>;
#else
  using physics = NothingHappens;
#endif
  using diagnostics = scree::WallForces;
};

void write(scree::Solver<Case>& solver) { solver.update_diagnostics(); }
