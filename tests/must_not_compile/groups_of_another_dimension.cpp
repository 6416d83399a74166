// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the groups have another dimension than the formulation
#include <scree/fields/groups.hpp>
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

double run(Points const& points, scree::Groups<2> const& walls, [[maybe_unused]] scree::Groups<3> const& others) {
#ifdef FIXED
  S const solver({.spacing = 0.1}, points, walls);
#else
  S const solver({.spacing = 0.1}, points, others);
#endif
  return solver.time();
}
