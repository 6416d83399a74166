// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the numbers of a formulation are float or double
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

struct Other :
#ifdef FIXED
    scree::Formulation<2, float>
#else
    scree::Formulation<2, int>
#endif
{
  using physics = NothingHappens;
};

double run(scree::Solver<Other>& solver) { return solver.time(); }
