// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `search` and `ghosts` of a formulation are templates
#include <scree/neighbours/cell_list.hpp>
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

struct Other : Case {
#ifdef FIXED
  template <class P>
  using search = scree::CellList<P>;
#else
  using search = scree::CellList<scree::basis_of<Case>>;
#endif
};

double run(scree::Solver<Other>& solver) { return solver.time(); }
