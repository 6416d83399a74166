// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `evolves` of `physics` is a list
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

struct Heat : NothingHappens {
#ifdef FIXED
  using evolves = scree::Fields<scree::Concentration>;
#else
  using evolves = scree::Concentration;
#endif
};
struct Other : Case {
  using physics = Heat;
};

double run(scree::Solver<Other>& solver) { return solver.time(); }
