// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../support/rows.hpp"

#include <chrono>
#include <map>
#include <string>

namespace scree::bench {
namespace detail {

struct Stopwatch {
  using Clock = std::chrono::steady_clock;
  std::string phase;
  Clock::time_point start;
  std::map<std::string, double> seconds;
};
inline Stopwatch& stopwatch() {
  static Stopwatch only;
  return only;
}
inline void begin_phase(char const* label, std::uint32_t, std::uint64_t*) {
  Space().fence();
  stopwatch().phase = label;
  stopwatch().start = Stopwatch::Clock::now();
}
inline void end_phase(std::uint64_t) {
  Space().fence();
  std::chrono::duration<double> const taken = Stopwatch::Clock::now() - stopwatch().start;
  stopwatch().seconds[stopwatch().phase] += taken.count();
}

}  // namespace detail

/// Seconds in kernels by their label while work() runs, with a wait after each kernel: nothing overlaps.
template <class Work>
std::map<std::string, double> phases_of(Work const& work) {
  namespace tools = Kokkos::Tools::Experimental;
  detail::stopwatch() = {};
  auto const before = tools::get_callbacks();
  tools::set_begin_parallel_for_callback(detail::begin_phase);
  tools::set_begin_parallel_reduce_callback(detail::begin_phase);
  tools::set_begin_parallel_scan_callback(detail::begin_phase);
  tools::set_end_parallel_for_callback(detail::end_phase);
  tools::set_end_parallel_reduce_callback(detail::end_phase);
  tools::set_end_parallel_scan_callback(detail::end_phase);
  work();
  tools::set_callbacks(before);
  return detail::stopwatch().seconds;
}

}  // namespace scree::bench
