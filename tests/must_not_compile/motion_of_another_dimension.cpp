// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `motion` has another dimension than the formulation
#include <scree/motion/translation.hpp>
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

struct Other : Case {
#ifdef FIXED
  using motion = scree::Translation<2>;
#else
  using motion = scree::Translation<3>;
#endif
};

double run(scree::Solver<Other>& solver) { return solver.time(); }
