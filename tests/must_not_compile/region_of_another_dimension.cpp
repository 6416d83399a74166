// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the region and the solver differ in their number of dimensions
#include <scree/probes/region.hpp>
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

double run(S const& solver) {
#ifdef FIXED
  scree::Box<2> const region{{0, 0}, {1, 1}};
#else
  scree::Box<3> const region{{0, 0, 0}, {1, 1, 1}};
#endif
  return mean_in(solver, scree::fields::concentration, region).value;
}
