// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <benchmark/benchmark.h>

#include "rows.hpp"

#include <exception>

namespace scree::bench {

/// Number of kernels launched before the host waits. On a GPU launches overlap with running kernels, so that only the
/// work itself is measured; `alone` is the time for a host that waits for each. On a CPU there is nothing to overlap.
inline constexpr int together = on_gpu ? 20 : 1, alone = 1;

/// Times `launch()`, which need not wait for the work that it starts.
template <class Launch>
void time(benchmark::State& state, int batch, Launch const& launch) {
  launch();  // touches memory and loads code before the clock starts
  Kokkos::fence();
  while (state.KeepRunningBatch(batch)) {
    for (int k = 0; k < batch; ++k) launch();
    Kokkos::fence();
  }
}

inline void count_particles(benchmark::State& state, double particles) {
  state.counters["particles"] = particles;
  state.counters["particles/s"] = benchmark::Counter(particles, benchmark::Counter::kIsIterationInvariantRate);
}
/// Pairs (i, j) within the support, without i itself; each counts for i and for j.
inline void count_pairs(benchmark::State& state, double particles, double pairs) {
  count_particles(state, particles);
  state.counters["pairs/particle"] = pairs / particles;
  state.counters["pairs/s"] = benchmark::Counter(pairs, benchmark::Counter::kIsIterationInvariantRate);
}

/// Adds a row that calls run(state). It counts wall-clock time, not that of the calling thread. A row that throws is
/// reported, and the next one runs.
template <class Run>
benchmark::internal::Benchmark* add_row(std::string const& name, Run const& run) {
  auto const guarded = [run](benchmark::State& state) {
    try {
      run(state);
    } catch (std::exception const& error) {
      state.SkipWithError(error.what());
    }
  };
  return benchmark::RegisterBenchmark(name.c_str(), guarded)->UseRealTime()->Unit(benchmark::kMicrosecond);
}

}  // namespace scree::bench
