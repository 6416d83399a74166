// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: a solver is made from a formulation, a class that derives from scree::Formulation
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

struct Case : scree::Formulation<2> {
  using physics = scree::Granular<>;
};
#ifdef FIXED
double run(scree::Solver<Case>& solver) { return solver.time(); }
#else
double run(scree::Solver<scree::Granular<>>& solver) { return solver.time(); }
#endif
