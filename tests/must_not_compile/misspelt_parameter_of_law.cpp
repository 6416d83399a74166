// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: each name in the braces must be a member of SolverSettings|the compiler then says which name is wrong
// not brief with Clang: it shows the sentence of a deleted constructor as numbers, and its declaration in a note
#include <scree/fields/groups.hpp>
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

struct Case : scree::Formulation<2> {
  using physics = scree::Granular<>;
};
double run(scree::Groups<2> const& groups) {
#ifdef FIXED
  scree::Solver<Case> const solver({.spacing = 0.1, .physics = {.law = {.mu_s = 0.4}}}, groups);
#else
  scree::Solver<Case> const solver({.spacing = 0.1, .physics = {.law = {.friction = 0.4}}}, groups);
#endif
  return solver.time();
}
