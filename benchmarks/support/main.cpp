// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <benchmark/benchmark.h>

#include "kept.hpp"

#include <Kokkos_Core.hpp>

#include <sstream>

#if !defined(NDEBUG) || defined(KOKKOS_ENABLE_DEBUG_BOUNDS_CHECK)
#error "scree's benchmarks mean nothing with assertions or bounds checks: build them with -DCMAKE_BUILD_TYPE=Release"
#endif

// The same main for every program: Google Benchmark's own between the initialisation and the end of Kokkos, with the
// conditions of the rows in the context of the results.
int main(int argc, char** argv) {
  Kokkos::ScopeGuard const kokkos(argc, argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;

  std::ostringstream configuration;
  Kokkos::print_configuration(configuration, false);
  benchmark::AddCustomContext("kokkos_configuration", configuration.str());
  benchmark::AddCustomContext("kokkos_version", std::to_string(KOKKOS_VERSION));
  benchmark::AddCustomContext("space", Kokkos::DefaultExecutionSpace::name());
  benchmark::AddCustomContext("concurrency", std::to_string(Kokkos::DefaultExecutionSpace().concurrency()));
#ifdef __clang__
  benchmark::AddCustomContext("compiler", __VERSION__);
#else
  benchmark::AddCustomContext("compiler", "GCC " __VERSION__);
#endif
#ifdef KOKKOS_ENABLE_CUDA
  benchmark::AddCustomContext("device", Kokkos::Cuda().cuda_device_prop().name);
  benchmark::AddCustomContext("cuda", std::to_string(CUDART_VERSION));
#endif

  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  scree::bench::forget();
}
