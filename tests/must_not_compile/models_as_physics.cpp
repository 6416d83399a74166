// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: a class of models is no `physics`: write using physics = scree::Granular<Models>
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

struct Sand : scree::GranularModels {};
struct Case : scree::Formulation<2> {
#ifdef FIXED
  using physics = scree::Granular<Sand>;
#else
  using physics = Sand;
#endif
};

double run(scree::Solver<Case>& solver) { return solver.time(); }
