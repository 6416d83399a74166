// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/memory.hpp"
#include "transport.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

// Tests of a transport at the start of a program.
namespace scree::detail {

/// Whether messages of `size` bytes arrive on this rank unchanged from every rank, when each rank sends to all ranks.
template <class T, class Space>
bool messages_arrive(T& transport, Space const& space, std::size_t size) {
  using InMemory = typename Space::memory_space;
  auto const ranks = std::size_t(transport.ranks());
  std::vector<unsigned char> bytes(ranks * size);
  auto const byte = [](std::size_t from, std::size_t to, std::size_t k) {
    return static_cast<unsigned char>(151 * from + 31 * to + k + k / 256);
  };
  auto const here = std::size_t(transport.rank());
  for (std::size_t q = 0; q < ranks; ++q)
    for (std::size_t k = 0; k < size; ++k) bytes[q * size + k] = byte(here, q, k);
  Memory<InMemory> const to_send("scree::trial", bytes.size()), room("scree::trial", bytes.size());
  copy_bytes<InMemory, Kokkos::HostSpace>(space, to_send.data(), bytes.data(), bytes.size());
  room.fill_with_zeros(space);
  Messages sent{to_send.data(), {0}};
  for (std::size_t q = 1; q <= ranks; ++q) sent.starts.push_back(std::int64_t(q * size));
  transport.exchange(space, sent, {room.data(), sent.starts});
  copy_bytes<Kokkos::HostSpace, InMemory>(space, bytes.data(), room.data(), bytes.size());
  bool arrived = true;
  for (std::size_t q = 0; q < ranks; ++q)
    for (std::size_t k = 0; k < size; ++k) arrived = arrived && bytes[q * size + k] == byte(q, here, k);
  return arrived;
}

/// Whether messages of 64 bytes and of 1 MiB arrive on this rank unchanged, see messages_arrive(). All ranks call this
/// function together.
template <class T, class Space>
bool short_and_long_arrive(T& transport, Space const& space) {
  bool arrive = messages_arrive(transport, space, 64);
  // The first test may have failed on this rank alone, so every rank takes part in both tests.
  arrive = messages_arrive(transport, space, std::size_t(1) << 20) && arrive;
  return arrive;
}

}  // namespace scree::detail
