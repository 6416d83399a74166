// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: each name in the braces must be a member of SolverSettings|the compiler then says which name is wrong
// not brief with Clang: it shows the sentence of a deleted constructor as numbers, and its declaration in a note
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

double run(Points const& points) {
#ifdef FIXED
  S const solver({.spacing = 0.1}, points);
#else
  S const solver({.spaceing = 0.1}, points);
#endif
  return solver.time();
}
