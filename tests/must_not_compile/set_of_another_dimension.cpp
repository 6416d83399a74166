// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: returns another kind of value than the field has
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

void run(S& solver) {
  using namespace scree::fields;
#ifdef FIXED
  solver.set(position, [](auto const&) { return scree::Vec<2, double>(0, 1); });
#else
  solver.set(position, [](auto const&) { return scree::Vec<3, double>(0, 0, 1); });
#endif
}
