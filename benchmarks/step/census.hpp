// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../support/rows.hpp"

#include <string_view>

namespace scree::bench {

/// Number of launches on the device, and of waits of the host for it.
struct Census {
  long launches = 0;  ///< of kernels
  long waits = 0;     ///< fences and copies to the host
};

namespace detail {
struct Counting {
  Census census;
  bool copying = false;  // a wait within a copy counts as part of the copy
};
inline Counting& counting() {
  static Counting only;
  return only;
}
inline void count_launch(char const*, std::uint32_t, std::uint64_t*) { ++counting().census.launches; }
inline void count_fence(char const* name, std::uint32_t, std::uint64_t*) {
  bool const by_tools = std::string_view(name).find("Tool Fence") != std::string_view::npos;
  if (!counting().copying && !by_tools) ++counting().census.waits;
}
inline void count_copy(Kokkos_Profiling_SpaceHandle to, char const*, void const*, Kokkos_Profiling_SpaceHandle from,
                       char const*, void const*, std::uint64_t) {
  counting().copying = true;
  bool const to_host = std::string_view(to.name) == Kokkos::HostSpace::name();
  if (to_host && std::string_view(from.name) != to.name) ++counting().census.waits;
}
inline void count_end_of_copy() { counting().copying = false; }
}  // namespace detail

/// The events that Kokkos reports to a tool while work() runs.
template <class Work>
Census census_of(Work const& work) {
  namespace tools = Kokkos::Tools::Experimental;
  detail::counting() = {};
  auto const before = tools::get_callbacks();
  tools::set_begin_parallel_for_callback(detail::count_launch);
  tools::set_begin_parallel_reduce_callback(detail::count_launch);
  tools::set_begin_parallel_scan_callback(detail::count_launch);
  tools::set_begin_fence_callback(detail::count_fence);
  tools::set_begin_deep_copy_callback(detail::count_copy);
  tools::set_end_deep_copy_callback(detail::count_end_of_copy);
  work();
  tools::set_callbacks(before);
  return detail::counting().census;
}

}  // namespace scree::bench
