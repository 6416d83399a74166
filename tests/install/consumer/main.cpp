// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/version.hpp>

#include <fmt/format.h>
#include <hdf5.h>
#include <Eigen/Core>
#include <Kokkos_Core.hpp>

struct Square {
  KOKKOS_FUNCTION void operator()(int i, double& sum) const { sum += double(i) * i; }
};

int main(int argc, char** argv) {
  fmt::print("scree {}.{}.{}\n", scree::library_version.major, scree::library_version.minor,
             scree::library_version.patch);
  if (H5open() < 0) return 1;
  if (argc > 1) return 0;  // only print the version: there may be no device here
  Kokkos::ScopeGuard const kokkos(argc, argv);
  double sum = 0;
  Kokkos::parallel_reduce("consumer", 4, Square{}, sum);
  return sum == 14 ? 0 : 1;
}
