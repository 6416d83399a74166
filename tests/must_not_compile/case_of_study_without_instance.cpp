// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: a case of a study is called with an execution-space instance

#include <scree/run/run_study.hpp>

void run() {
  using Space = Kokkos::DefaultExecutionSpace;
#ifdef FIXED
  std::vector<std::function<double(Space const&)>> const cases;
#else
  std::vector<std::function<double()>> const cases;
#endif
  scree::run_study<Space>(cases, 2);
}
