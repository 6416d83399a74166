// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the material carries no concentration whose mixing could be measured
#include <scree/granular/granular.hpp>
#include <scree/mixing/lacey.hpp>
#include <scree/solver/solver.hpp>

struct Case : scree::Formulation<2> {
  using physics = scree::Granular<>;
#ifdef FIXED
  using carries = scree::Fields<scree::Concentration>;
#endif
};

double mixing_of(scree::Solver<Case> const& solver) { return scree::lacey_index(solver, {.cell = 0.1}).index; }
