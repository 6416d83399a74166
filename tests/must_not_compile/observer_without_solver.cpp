// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the action of an observer is a function of the solver
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

void run(S& solver) {
#ifdef FIXED
  solver.run(1, {scree::every<S>(0.1, [](S&) {})});
#else
  solver.run(1, {scree::every<S>(0.1, [] {})});
#endif
}
