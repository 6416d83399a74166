// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: a case of a study returns its result

#include <scree/run/run_study.hpp>

void run() {
  using Space = Kokkos::DefaultExecutionSpace;
#ifdef FIXED
  std::vector<std::function<double(Space const&)>> const cases;
#else
  std::vector<std::function<void(Space const&)>> const cases;
#endif
  scree::run_study<Space>(cases, 2);
}
