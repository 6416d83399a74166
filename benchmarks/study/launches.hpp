// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../support/rows.hpp"

#include <scree/core/instances.hpp>

#include <array>
#include <barrier>
#include <chrono>
#include <thread>
#include <utility>

// How many launches of an empty kernel host threads achieve together, each on its instance: the limit of many small
// solvers in one process.
namespace scree::bench {

inline double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Runs work(k) in `count` threads; seconds from the moment that all are ready.
template <class Prepare, class Work>
double seconds_of(int count, Prepare const& prepare, Work const& work) {
  double begin = 0;
  std::barrier ready(count, [&]() noexcept { begin = now(); });
  {
    std::vector<std::jthread> threads;
    for (int k = 0; k < count; ++k)
      threads.emplace_back([&, k] {
        prepare(k);
        ready.arrive_and_wait();
        work(k);
      });
  }
  return now() - begin;
}

/// A kernel of its own for each number, because Kokkos lets launches of one kernel take turns.
template <int Number>
struct Nothing {
  SCREE_FN void operator()(int) const {}
};
inline constexpr int most_threads = 16;

template <int Number>
void launch_nothing(Space const& space, int launches) {
  for (int k = 0; k < launches; ++k)
    Kokkos::parallel_for("scree::bench::nothing", Kokkos::RangePolicy<Space>(space, 0, 1), Nothing<Number>());
  space.fence();
}
template <std::size_t... K>
auto launchers(std::index_sequence<K...>) {
  return std::array<void (*)(Space const&, int), sizeof...(K)>{launch_nothing<int(K)>...};
}

/// Launches per second of all threads together, of one kernel or of one for each thread.
inline double launch_rate(int threads, int launches, bool one_kernel) {
  auto const instances = instances_of<Space>(threads);
  auto const all = launchers(std::make_index_sequence<most_threads>());
  auto const launch = [&](int k, int count) {
    all[one_kernel ? 0 : std::size_t(k) % all.size()](instances[std::size_t(k)], count);
  };
  double const seconds = seconds_of(
      threads, [&](int k) { launch(k, 10); }, [&](int k) { launch(k, launches); });
  return threads * double(launches) / seconds;
}

}  // namespace scree::bench
