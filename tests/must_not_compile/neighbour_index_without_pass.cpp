// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: no pass computes `unlike_neighbours`: name NeighbourMixing in `diagnostics` of the formulation
#include <scree/granular/segregating.hpp>
#include <scree/mixing/neighbours.hpp>
#include <scree/segregation/constant_closure.hpp>
#include <scree/solver/solver.hpp>

struct Case : scree::Formulation<2> {
  using physics = scree::SegregatingGranular<scree::Granular<>, scree::ConservativeSegregation<scree::ConstantClosure>>;
#ifdef FIXED
  using diagnostics = scree::NeighbourMixing<>;
#endif
};

double mixing_of(scree::Solver<Case>& solver) { return scree::neighbour_index(solver).value; }
