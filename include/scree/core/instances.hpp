// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "setting.hpp"
#include "space.hpp"

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace scree {

/// Returns new instances of an execution space, none of which is the default instance. On a GPU, the instances are
/// streams. On a host, they are thread pools of equal size, among which the threads of the default instance are
/// divided; each pool has at least one thread. Throws std::invalid_argument for fewer than one instance.
template <class Space>
std::vector<Space> instances_of(int count) {
  check_setting(count > 0, "the number of instances", count, "1 or more");
  std::vector<Space> instances;
  // With Serial, and with OpenMP unless OMP_MAX_ACTIVE_LEVELS allows nested regions, partition_space() returns copies
  // of a single instance.
#ifdef KOKKOS_ENABLE_OPENMP
  if constexpr (std::is_same_v<Space, Kokkos::OpenMP>) {
    int const threads = std::max(1, Space().concurrency() / count);
    for (int k = 0; k < count; ++k) instances.push_back(Space(threads));
  }
#endif
#ifdef KOKKOS_ENABLE_SERIAL
  if constexpr (std::is_same_v<Space, Kokkos::Serial>)
    for (int k = 0; k < count; ++k) instances.push_back(Space(Kokkos::NewInstance()));
#endif
  if (instances.empty())
    instances = Kokkos::Experimental::partition_space(Space(), std::vector<int>(std::size_t(count), 1));
  return instances;
}

}  // namespace scree
