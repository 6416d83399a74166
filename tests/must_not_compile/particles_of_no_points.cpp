// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: particles are std::vector<Vec<dim, real>>, or Groups<dim>, or SharedPoints<dim>
#include <scree/setup/lattice.hpp>
#include <scree/setup/shapes.hpp>
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

double run(scree::Ball<2> const& ball) {
#ifdef FIXED
  S const solver({.spacing = 0.1}, scree::fill_lattice(ball, 0.1));
#else
  S const solver({.spacing = 0.1}, ball);
#endif
  return solver.time();
}
