// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the value given to add\(\) is of another kind than the field
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

void run(S& solver, Points const& points) {
  using namespace scree::fields;
#ifdef FIXED
  solver.add(points, scree::given(concentration, 0.5));
#else
  solver.add(points, scree::given(concentration, scree::Vec<2, double>(0, 1)));
#endif
}
