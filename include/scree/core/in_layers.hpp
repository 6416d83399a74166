// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "loop.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>

namespace scree::detail {

/// Calls work(layer) for each layer in [0, layers), on the host threads of Kokkos if Kokkos is initialised and
/// otherwise on the calling thread. A thread takes the next layer when it has finished its previous one. If `work`
/// throws, skips the remaining layers and throws one of the exceptions.
template <class Work>
void for_each_layer(long layers, Work const& work) {
  std::atomic<long> next = 0;
  std::exception_ptr failure;
  std::mutex of_failure;
  auto const take_layers = [&](int, int, int) {
    try {
      for (long layer = next++; layer < layers; layer = next++) work(layer);
    } catch (...) {
      std::lock_guard const lock(of_failure);
      failure = std::current_exception();
      next = layers;
    }
  };
  int threads = 1;
  if (Kokkos::is_initialized()) {
    Kokkos::DefaultHostExecutionSpace const host;
    threads = portions_of(host, static_cast<int>(std::min<long>(layers, std::numeric_limits<int>::max())));
    if (threads > 1) for_each_portion(host, "scree::set_up", 0, threads, threads, take_layers);
  }
  if (threads <= 1) take_layers(0, 0, 1);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace scree::detail
