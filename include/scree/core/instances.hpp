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

/// New instances of an execution space, none of them the default one: on a GPU streams, on a host pools of threads of
/// the same size, which share the threads of the default instance and have one at least.
/// Throws std::invalid_argument for less than one instance.
template <class Space>
std::vector<Space> instances_of(int count) {
  check_setting(count > 0, "the number of instances", count, "1 or more");
  std::vector<Space> instances;
  // partition_space() returns copies of one instance with OpenMP, unless OMP_MAX_ACTIVE_LEVELS allows nested regions,
  // and with Serial.
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
