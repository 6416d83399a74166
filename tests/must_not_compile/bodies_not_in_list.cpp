// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `bodies` of a formulation is a list
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

struct Other : Case {
#ifdef FIXED
  using bodies = scree::Bodies<scree::Material>;
#else
  using bodies = scree::Material;
#endif
};

double run(scree::Solver<Other>& solver) { return solver.time(); }
