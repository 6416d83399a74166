// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: at\(\) takes a list of times
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

void run(S& solver) {
#ifdef FIXED
  solver.run(1, {scree::at<S>({0.1}, [](S&) {})});
#else
  solver.run(1, {scree::at<S>(0.1, [](S&) {})});
#endif
}
