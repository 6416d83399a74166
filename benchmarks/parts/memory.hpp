// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/core/space.hpp>
#include <scree/distributed/part_figures.hpp>
#include <scree/distributed/team.hpp>

#include <Kokkos_Core.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

// Peaks of the memory of this process.
namespace scree::bench {

/// Bytes that Kokkos has allocated for the default execution space, and the most there ever were.
inline std::atomic<std::int64_t> allocated = 0, most_allocated = 0;

/// Counts them from now on.
inline void count_memory() {
  using Handle = Kokkos::Tools::SpaceHandle;
  static auto const is_ours = [](Handle const& space) {
    return std::string_view(space.name) == Kokkos::DefaultExecutionSpace::memory_space::name();
  };
  Kokkos::Tools::Experimental::set_allocate_data_callback(
      [](Handle const space, char const*, void const*, std::uint64_t const bytes) {
        if (!is_ours(space)) return;
        std::int64_t const now = allocated += std::int64_t(bytes);
        for (std::int64_t most = most_allocated; most < now && !most_allocated.compare_exchange_weak(most, now);)
          continue;
      });
  Kokkos::Tools::Experimental::set_deallocate_data_callback(
      [](Handle const space, char const*, void const*, std::uint64_t const bytes) {
        if (is_ours(space)) allocated -= std::int64_t(bytes);
      });
}
/// The most memory of the host that this process ever had, in bytes; 0 where the system does not tell.
inline std::int64_t most_of_host() {
  long kibibytes = 0;
  if (std::FILE* const file = std::fopen("/proc/self/status", "r")) {
    char line[256];
    while (std::fgets(line, sizeof line, file))
      if (std::sscanf(line, "VmHWM: %ld", &kibibytes) == 1) break;
    std::fclose(file);
  }
  return 1024 * std::int64_t(kibibytes);
}

/// Peaks at some moments, of the part with the most. Parts that are threads share the memory of the process.
class MemoryPeaks {
 public:
  using TeamOf = Team<Kokkos::DefaultExecutionSpace>;
  /// Values of the host count from here.
  explicit MemoryPeaks(TeamOf const& team) : team_(team), before_(most_of_host()) {}
  void note(std::string const& when) {
    peaks_.push_back({when, team_.largest(std::int64_t(most_allocated)), team_.largest(most_of_host() - before_)});
  }
  /// Bytes per particle of the largest part.
  void print(std::string const& precision, std::vector<PartProfile> const& parts) const {
    double most = 1;
    for (PartProfile const& part : parts) most = std::max(most, double(part.particles));
    if (team_.part() != 0) return;
    for (auto const& [when, device, host] : peaks_)
      fmt::print(
          "memory until {}, {}, {} parts, the largest has {:.0f} particles: Kokkos {:.1f} MB, {:.0f} bytes for "
          "each; process {:.1f} MB, {:.0f} for each\n",
          when, precision, parts.size(), most, 1e-6 * double(device), double(device) / most, 1e-6 * double(host),
          double(host) / most);
  }

 private:
  struct Peak {
    std::string when;
    std::int64_t device, host;
  };
  TeamOf team_;
  std::int64_t before_;
  std::vector<Peak> peaks_;
};

}  // namespace scree::bench
