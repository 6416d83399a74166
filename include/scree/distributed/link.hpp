// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/memory.hpp"
#include "team.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace scree {
namespace detail {

/// Returns the median time (s) of seven exchanges in which each rank sends a message to the next one, on the slowest
/// rank.
template <class Space>
double time_of_ring(Team<Space> const& team, Space const& space, std::int64_t bytes) {
  using Bytes = Memory<typename Space::memory_space>;
  Bytes const to_send("scree::link", std::size_t(bytes)), to_receive("scree::link", std::size_t(bytes));
  int const ranks = team.ranks();
  auto const message_with = [&](Bytes const& memory, int other) {
    Messages messages{memory.data(), std::vector<std::int64_t>(std::size_t(ranks) + 1, bytes)};
    std::fill_n(messages.starts.begin(), other + 1, 0);
    return messages;
  };
  Messages const sent = message_with(to_send, (team.rank() + 1) % ranks),
                 received = message_with(to_receive, (team.rank() + ranks - 1) % ranks);
  std::array<double, 7> times = {};
  for (double& time : times) {
    team.gather(0);  // a barrier: all ranks begin together
    Kokkos::Timer const timer;
    team.exchange(space, sent, received);
    space.fence("scree::link");
    time = timer.seconds();
  }
  std::nth_element(times.begin(), times.begin() + times.size() / 2, times.end());
  return team.largest(times[times.size() / 2]);
}

}  // namespace detail

/// Returns the latency and bandwidth of messages between the ranks, measured with messages of 8 bytes and 16 MiB. The
/// measurement takes at most a tenth of a second if messages travel at 2 GB/s. All ranks call this function together.
template <class Space>
Link measured_link(Team<Space> const& team, Space const& space) {
  constexpr std::int64_t large = 1 << 24;
  double const latency = detail::time_of_ring(team, space, 8);
  return {latency, double(large) / detail::time_of_ring(team, space, large)};
}

}  // namespace scree
