// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: a condition is a struct with a list `reads`
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

void run(S& solver) {
#ifdef FIXED
  solver.remove(scree::Within<2>{.low = {0, 0}, .high = {1, 1}});
#else
  solver.remove([](scree::Vec<2, double> const& x) { return x[0] > 1; });
#endif
}
