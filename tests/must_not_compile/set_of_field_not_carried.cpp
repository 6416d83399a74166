// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: these particles do not carry this field
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

void run(S& solver) {
  using namespace scree::fields;
#ifdef FIXED
  solver.set(concentration, [](auto const&) { return 0.5; });
#else
  solver.set(density, [](auto const&) { return 0.5; });
#endif
}
