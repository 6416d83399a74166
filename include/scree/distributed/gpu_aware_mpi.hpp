// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#if __has_include(<mpi.h>)  // programs that use this header need the include folder and the library of an MPI

#include "mpi.hpp"

#if __has_include(<mpi-ext.h>)
#include <mpi-ext.h>
#endif

#include <cstddef>
#include <cstdint>
#include <vector>

// Whether MPI can read and write memory of GPUs.
namespace scree::detail {

/// Whether the library says so, of NVIDIA GPUs.
inline bool says_gpu_aware() {
  int says = 0;
#if defined(MPIX_GPU_SUPPORT_CUDA)
  MPIX_GPU_query_support(MPIX_GPU_SUPPORT_CUDA, &says);
#elif defined(MPIX_CUDA_AWARE_SUPPORT)
  says = MPIX_Query_cuda_support();
#endif
  return says == 1;
}

/// Whether messages of `size` bytes from each part to each arrive whole on this one.
template <class T, class Space>
bool messages_arrive(T& transport, Space const& space, std::size_t size) {
  using InMemory = typename Space::memory_space;
  auto const parts = std::size_t(transport.parts());
  std::vector<unsigned char> bytes(parts * size);
  auto const byte = [](std::size_t from, std::size_t to, std::size_t k) {
    return static_cast<unsigned char>(151 * from + 31 * to + k + k / 256);
  };
  auto const here = std::size_t(transport.part());
  for (std::size_t q = 0; q < parts; ++q)
    for (std::size_t k = 0; k < size; ++k) bytes[q * size + k] = byte(here, q, k);
  Memory<InMemory> const to_send("scree::trial", bytes.size()), room("scree::trial", bytes.size());
  copy_bytes<InMemory, Kokkos::HostSpace>(space, to_send.data(), bytes.data(), bytes.size());
  room.fill_with_zeros(space);
  Messages sent{to_send.data(), {0}};
  for (std::size_t q = 1; q <= parts; ++q) sent.starts.push_back(std::int64_t(q * size));
  transport.exchange(space, sent, {room.data(), sent.starts});
  copy_bytes<Kokkos::HostSpace, InMemory>(space, bytes.data(), room.data(), bytes.size());
  bool arrived = true;
  for (std::size_t q = 0; q < parts; ++q)
    for (std::size_t k = 0; k < size; ++k) arrived = arrived && bytes[q * size + k] == byte(q, here, k);
  return arrived;
}

/// Whether the answer of all ranks is yes.
inline bool all_say(Mpi& mpi, bool yes) {
  char const mine = yes ? 1 : 0;
  std::vector<char> all(std::size_t(mpi.parts()));
  mpi.gather(&mine, 1, all.data());
  for (char const each : all) yes = yes && each == 1;
  return yes;
}

/// Whether short and long messages between GPUs arrive without a way through memory of the host. A library that cannot
/// do this may end the program. All ranks call it together.
template <class Space>
bool is_gpu_aware(MPI_Comm communicator, Space const& space) {
  Mpi direct(communicator, DeviceMessages::direct);
  bool const arrive = messages_arrive(direct, space, 64) && messages_arrive(direct, space, std::size_t(1) << 20);
  return all_say(direct, arrive);
}

}  // namespace scree::detail

#endif
