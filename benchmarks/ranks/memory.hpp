// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/core/space.hpp>
#include <scree/distributed/rank_figures.hpp>
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

/// Bytes that are allocated, and the most there ever were.
class Peak {
 public:
  void add(std::int64_t bytes) {
    std::int64_t const now = now_ += bytes;
    for (std::int64_t most = most_; most < now && !most_.compare_exchange_weak(most, now);) continue;
  }
  std::int64_t most() const { return most_; }

 private:
  std::atomic<std::int64_t> now_ = 0, most_ = 0;
};
/// Peaks of the memory of Kokkos in the default execution space, and of containers of the host.
inline Peak of_kokkos;
extern Peak containers;

/// Counts the memory of Kokkos from now on.
inline void count_memory() {
  using Handle = Kokkos::Tools::SpaceHandle;
  static auto const is_ours = [](Handle const& space) {
    return std::string_view(space.name) == Kokkos::DefaultExecutionSpace::memory_space::name();
  };
  Kokkos::Tools::Experimental::set_allocate_data_callback(
      [](Handle const space, char const*, void const*, std::uint64_t const bytes) {
        if (is_ours(space)) of_kokkos.add(std::int64_t(bytes));
      });
  Kokkos::Tools::Experimental::set_deallocate_data_callback(
      [](Handle const space, char const*, void const*, std::uint64_t const bytes) {
        if (is_ours(space)) of_kokkos.add(-std::int64_t(bytes));
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

/// Peaks at some moments, of the process with the most.
class MemoryPeaks {
 public:
  using TeamOf = Team<Kokkos::DefaultExecutionSpace>;
  /// `tells`: prints each moment when it comes.
  MemoryPeaks(TeamOf const& team, bool tells) : team_(team), tells_(tells) {}
  void note(std::string const& when) {
    if (tells_ && team_.rank() == 0) fmt::print("{} after {:.1f} s\n", when, timer_.seconds()), std::fflush(stdout);
    peaks_.push_back(
        {when, team_.largest(of_kokkos.most()), team_.largest(containers.most()), team_.largest(most_of_host())});
  }
  /// In MB, and in bytes for each particle of the process.
  void print(std::string const& precision, std::vector<RankProfile> const& ranks, bool one_process) const {
    double all = 0, most = 0;
    for (RankProfile const& rank : ranks) all += double(rank.particles), most = std::max(most, double(rank.particles));
    double const here = one_process ? all : most;
    if (team_.rank() != 0) return;
    for (auto const& [when, kokkos, host, process] : peaks_)
      fmt::print(
          "memory until {}, {}, {} ranks, {:.0f} particles of the process: Kokkos {:.1f} MB, {:.0f} "
          "bytes for each; containers of the host {:.1f} MB, {:.0f} for each; VmHWM {:.1f} MB\n",
          when, precision, ranks.size(), here, 1e-6 * double(kokkos), double(kokkos) / here, 1e-6 * double(host),
          double(host) / here, 1e-6 * double(process));
  }

 private:
  struct At {
    std::string when;
    std::int64_t kokkos, host, process;
  };
  TeamOf team_;
  bool tells_;
  Kokkos::Timer timer_;
  std::vector<At> peaks_;
};

}  // namespace scree::bench
