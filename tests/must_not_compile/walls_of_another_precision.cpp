// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the points have another dimension or precision than the formulation
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

double run(Points const& points, [[maybe_unused]] std::vector<scree::Vec<2, float>> const& walls) {
#ifdef FIXED
  S const solver({.spacing = 0.1}, points, points);
#else
  S const solver({.spacing = 0.1}, points, walls);
#endif
  return solver.time();
}
