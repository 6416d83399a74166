// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "../support/streams.hpp"

#include <Kokkos_Core.hpp>

namespace column_collapse {
int run(int argc, char** argv);  // run.cpp
}

int main(int argc, char** argv) {
  support::guard_streams();
  Kokkos::ScopeGuard const kokkos(argc, argv);
  return column_collapse::run(argc, argv);
}
