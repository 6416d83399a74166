// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: an integrator is no `physics`: write using integrator
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

struct Case : scree::Formulation<2> {
#ifdef FIXED
  using physics = scree::Granular<>;
  using integrator = scree::Midpoint;
#else
  using physics = scree::Midpoint;
#endif
};

double run(scree::Solver<Case>& solver) { return solver.time(); }
