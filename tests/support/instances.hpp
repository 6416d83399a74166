// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <Kokkos_Core.hpp>

#include <array>
#include <type_traits>

namespace scree::test {

/// Two instances of an execution space, neither of them the default one: their loops may run at the same time, on a GPU
/// in two streams.
template <class Space>
std::array<Space, 2> two_instances() {
#ifdef KOKKOS_ENABLE_OPENMP
  if constexpr (std::is_same_v<Space, Kokkos::OpenMP>) {
    // partition_space() returns the default instance, unless OMP_MAX_ACTIVE_LEVELS allows nested regions.
    int const threads = Space().concurrency();
    return {Space(threads), Space(threads)};
  }
#endif
  auto const parts = Kokkos::Experimental::partition_space(Space(), 1, 1);
  return {parts[0], parts[1]};
}

}  // namespace scree::test
