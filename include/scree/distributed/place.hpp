// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/space.hpp"
#include "rank_figures.hpp"

#include <Kokkos_Core.hpp>

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <type_traits>

namespace scree {

/// Returns the host and device of an execution space instance.
template <class Space>
Place place_of(Space const& space) {
  Place place;
  if (gethostname(place.host, sizeof place.host - 1) != 0) std::snprintf(place.host, sizeof place.host, "unknown");
  if constexpr (on_host<Space>) place.threads = space.concurrency();
#ifdef KOKKOS_ENABLE_CUDA
  if constexpr (std::is_same_v<Space, Kokkos::Cuda>) {
    cudaDeviceProp const& properties = space.cuda_device_prop();
    std::copy_n(properties.name, sizeof place.device - 1, place.device);
    place.number = space.cuda_device();
  }
#endif
  return place;
}

}  // namespace scree
