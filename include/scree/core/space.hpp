// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <Kokkos_Core.hpp>

#include <stdexcept>
#include <string>
#include <string_view>

// The execution space of loops and the memory space of their arrays. An instance of an execution space runs its loops
// one after another. Loops of another instance may run at the same time.
namespace scree {

/// Whether loops of an execution space work in host memory.
template <class Space>
inline constexpr bool on_host = Kokkos::SpaceAccessibility<Kokkos::HostSpace, typename Space::memory_space>::accessible;

/// The memory in which a policy stores particles.
template <class P>
using memory_of = typename P::space::memory_space;

/// Whether the host can access the memory of a policy.
template <class P>
inline constexpr bool runs_on_host = on_host<typename P::space>;

/// A named part of the run in profiles, to the end of the scope. Without a profiler it costs nothing, not even a
/// string.
class ProfilingRegion {
 public:
  /// Begins a region with this name.
  explicit ProfilingRegion(std::string_view name) : is_seen_(Kokkos::Profiling::profileLibraryLoaded()) {
    if (is_seen_) Kokkos::Profiling::pushRegion(std::string(name));
  }
  ProfilingRegion(ProfilingRegion const&) = delete;
  ~ProfilingRegion() {
    if (is_seen_) Kokkos::Profiling::popRegion();
  }

 private:
  bool is_seen_;
};

/// Throws std::invalid_argument unless two instances are the same: loops of different ones do not wait for each other.
template <class Space>
void check_same_instance(Space const& one, Space const& other) {
  if (one != other)
    throw std::invalid_argument(
        "scree: particles or arrays that are used together must be made on the same execution-space instance");
}

}  // namespace scree
