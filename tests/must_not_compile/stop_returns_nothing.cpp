// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `stop` is a function of the solver that returns a bool
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

void run(S& solver) {
#ifdef FIXED
  solver.run(1, {}, [](S const&) { return false; });
#else
  solver.run(1, {}, [](S const&) {});
#endif
}
