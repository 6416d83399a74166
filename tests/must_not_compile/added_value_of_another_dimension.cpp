// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the value given to add\(\) is of another kind than the field
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

void run(S& solver, Points const& points) {
#ifdef FIXED
  scree::Vec<2, double> const u(0, 1);
#else
  scree::Vec<3, double> const u(0, 0, 1);
#endif
  solver.add(points, scree::given(scree::fields::position, u));
}
