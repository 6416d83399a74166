// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#if __has_include(<mpi.h>)  // programs that use this header need the include folder and the library of an MPI

#include "cuda_blocks.hpp"
#include "mpi.hpp"
#include "peer_memory.hpp"

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace scree {
namespace detail {

/// Whether all ranks are on one host.
inline bool are_on_one_host(Mpi const& mpi) {
  MPI_Comm here = MPI_COMM_NULL;
  MPI_Comm_split_type(mpi.communicator(), MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
  int count = 0;
  MPI_Comm_size(here, &count);
  MPI_Comm_free(&here);
  return count == mpi.parts();
}

#ifdef KOKKOS_ENABLE_CUDA
/// The reason why this rank cannot map the memory of another one; "" if it can map all. All ranks call it together.
inline std::string fault_of_peers(Mpi& mpi) {
  std::string fault;
  cudaIpcMemHandle_t mine = {};
  std::unique_ptr<CudaBlocks::Block> block;
  try {
    block = std::make_unique<CudaBlocks::Block>(std::size_t(1) << 20);
    mine = block->handle();
  } catch (std::runtime_error const& error) {
    fault = error.what();
  }
  auto const count = static_cast<std::size_t>(mpi.parts());
  std::vector<cudaIpcMemHandle_t> all(count);
  mpi.gather(&mine, sizeof mine, all.data());
  for (int q = 0; q < mpi.parts() && fault.empty(); ++q) {
    if (q == mpi.part()) continue;
    try {
      CudaBlocks::Mapped const other(all[std::size_t(q)]);
    } catch (std::runtime_error const& error) {
      fault = error.what();
    }
  }
  // Nobody gives its memory back before all have closed it; and all choose alike.
  char here = fault.empty() ? 0 : 1;
  std::vector<char> faults(count);
  mpi.gather(&here, 1, faults.data());
  for (char const each : faults)
    if (each != 0 && fault.empty()) fault = "another rank cannot map memory of GPUs";
  return fault;
}
#endif

}  // namespace detail

/// The ranks of a communicator as parts. Between NVIDIA GPUs of one host they write into each other's memory
/// (PeerMemory), if a test says that they can; otherwise messages are MPI's. The environment variable SCREE_TRANSPORT
/// asks for one of them: `mpi`, or `peers`, which throws std::runtime_error where it is impossible.
template <class Space>
Team<Space> team_of_ranks(MPI_Comm communicator = MPI_COMM_WORLD) {
  Mpi mpi(communicator);
  char const* const asked = std::getenv("SCREE_TRANSPORT");
  std::string_view const transport = asked == nullptr ? "" : asked;
  if (!transport.empty() && transport != "mpi" && transport != "peers")
    throw std::runtime_error("scree: SCREE_TRANSPORT is '" + std::string(transport) + "'; allowed: mpi, peers");
  std::string fault = "only between NVIDIA GPUs";
#ifdef KOKKOS_ENABLE_CUDA
  if constexpr (std::is_same_v<Space, Kokkos::Cuda>) {
    if (transport != "mpi" && mpi.parts() > 1) {
      fault = detail::are_on_one_host(mpi) ? detail::fault_of_peers(mpi) : "the ranks are on several hosts";
      if (fault.empty()) return Team<Space>(PeerMemory<CudaBlocks>(mpi));
    }
  }
#endif
  if (transport == "peers" && mpi.parts() > 1)
    throw std::runtime_error("scree: SCREE_TRANSPORT=peers is not possible: " + fault);
  return Team<Space>(std::move(mpi));
}

/// Calls function(team, space) with the ranks of MPI_COMM_WORLD as parts. If it throws on one of them, the message goes
/// to stderr and all processes end. MPI and Kokkos must have been initialised; Kokkos chooses the device of a rank by
/// its number on the host.
template <class Space, class Function>
void run_on_ranks(Function const& function) {
  Mpi mpi;
  detail::OnThisPart const here{mpi.part()};
  try {
    function(team_of_ranks<Space>(), Space());
  } catch (std::exception const& error) {
    mpi.fail(error.what());
  } catch (...) {
    mpi.fail("unknown error");
  }
}

}  // namespace scree

#endif
