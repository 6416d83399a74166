// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <Kokkos_Core.hpp>

#include <stdexcept>
#include <string>
#include <string_view>

// The execution space of loops and the memory space of their arrays. Loops on one instance of an execution space run
// one after another; loops on different instances may run at the same time.
namespace scree {

/// Whether the host can access the memory of an execution space.
template <class Space>
inline constexpr bool on_host = Kokkos::SpaceAccessibility<Kokkos::HostSpace, typename Space::memory_space>::accessible;

/// The memory space in which a policy stores particles.
template <class P>
using memory_of = typename P::space::memory_space;

/// Whether the host can access the memory of a policy.
template <class P>
inline constexpr bool runs_on_host = on_host<typename P::space>;

/// A named region of a run in profiles, which ends with the scope of the object. Without a profiler, it costs nothing,
/// not even the construction of a string.
class ProfilingRegion {
 public:
  /// Begins a region with this name, or none if the name is empty.
  explicit ProfilingRegion(std::string_view name)
      : is_seen_(!name.empty() && Kokkos::Profiling::profileLibraryLoaded()) {
    if (is_seen_) Kokkos::Profiling::pushRegion(std::string(name));
  }
  ProfilingRegion(ProfilingRegion const&) = delete;
  ~ProfilingRegion() {
    if (is_seen_) Kokkos::Profiling::popRegion();
  }

 private:
  bool is_seen_;
};

/// Throws std::invalid_argument unless two instances are the same, because loops on different instances do not wait for
/// each other.
template <class Space>
void check_same_instance(Space const& one, Space const& other) {
  if (one != other)
    throw std::invalid_argument(
        "scree: particles or arrays that are used together must be made on the same execution-space instance");
}

}  // namespace scree
