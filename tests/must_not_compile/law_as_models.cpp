// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: Granular takes a class of models
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

struct Sand : scree::GranularModels {
  using law = scree::MuOfI<>;
};
struct Case : scree::Formulation<2> {
#ifdef FIXED
  using physics = scree::Granular<Sand>;
#else
  using physics = scree::Granular<scree::MuOfI<>>;
#endif
};

double run(scree::Solver<Case>& solver) { return solver.time(); }
