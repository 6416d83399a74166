// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/streams.hpp>

#include <Kokkos_Core.hpp>

namespace drum {
int run(int argc, char** argv);  // run.cpp
}

int main(int argc, char** argv) {
  scree::app::guard_streams();
  Kokkos::ScopeGuard const kokkos(argc, argv);
  return drum::run(argc, argv);
}
