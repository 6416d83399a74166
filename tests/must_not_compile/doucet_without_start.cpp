// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the material does not carry where its particles were at the start
#include <scree/granular/granular.hpp>
#include <scree/mixing/doucet.hpp>
#include <scree/solver/solver.hpp>

struct Case : scree::Formulation<2> {
  using physics = scree::Granular<>;
#ifdef FIXED
  using carries = scree::Fields<scree::StartPosition>;
#endif
};

double mixing_of(scree::Solver<Case> const& solver) { return scree::doucet_index(solver).index; }
