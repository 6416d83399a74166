// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `carries` of a formulation is a list
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

struct Other : Case {
#ifdef FIXED
  using carries = scree::Fields<scree::Density>;
#else
  using carries = scree::Density;
#endif
};

double run(scree::Solver<Other>& solver) { return solver.time(); }
