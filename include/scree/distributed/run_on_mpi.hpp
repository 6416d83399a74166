// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#if __has_include(<mpi.h>)  // programs that use this header need the headers and the library of MPI

#include "cuda_blocks.hpp"
#include "gpu_aware_mpi.hpp"
#include "host_blocks.hpp"
#include "marks.hpp"
#include "messages_arrive.hpp"
#include "mpi.hpp"
#include "peer_memory.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
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
  return count == mpi.ranks();
}

/// Returns why this rank cannot map blocks of another rank or wait for its marks, or "" if all ranks can. All ranks
/// call this function together.
template <class Blocks, class Mark, class Space>
std::string fault_of_peers(Mpi& mpi, Space const& space) {
  std::string fault;
  struct Handles {
    typename Blocks::Handle block;
    typename Mark::Handle mark;
  } mine = {};
  std::unique_ptr<typename Blocks::Block> block;
  std::unique_ptr<Mark> mark;
  try {
    block = std::make_unique<typename Blocks::Block>(std::size_t(1) << 20);
    mark = std::make_unique<Mark>();
    mark->set(space);
    mine = {block->handle(), mark->handle()};
  } catch (std::runtime_error const& error) {
    fault = error.what();
  }
  auto const count = static_cast<std::size_t>(mpi.ranks());
  std::vector<Handles> all(count);
  mpi.gather(&mine, sizeof mine, all.data());
  for (int q = 0; q < mpi.ranks() && fault.empty(); ++q) {
    if (q == mpi.rank()) continue;
    try {
      typename Blocks::Mapped const other(all[std::size_t(q)].block);
      typename Mark::Found const found(all[std::size_t(q)].mark);
      found.pass(space);
      space.fence("scree::trial");
    } catch (std::runtime_error const& error) {
      fault = error.what();
    }
  }
  // No rank frees its memory before every rank has unmapped it, and all ranks reach the same decision.
  if (!all_say(mpi, fault.empty()) && fault.empty()) fault = "another rank cannot map the memory";
  return fault;
}

/// Returns a team of the MPI processes that write to each other's `Blocks`. If that is impossible, returns none and
/// sets `fault` to the reason.
template <class Blocks, class Mark, class Space>
std::optional<Team<Space>> team_with(Mpi& mpi, Space const& space, std::string& fault) {
  fault = are_on_one_host(mpi) ? fault_of_peers<Blocks, Mark>(mpi, space) : "the ranks are on several hosts";
  if (!fault.empty()) return {};
  PeerMemory<Blocks, Mark> peers(mpi);
  if (all_say(mpi, short_and_long_arrive(peers, space))) return Team<Space>(std::move(peers));
  fault = "messages do not arrive whole";
  return {};
}
/// Returns a team of the MPI processes that write to each other's `Blocks`, synchronised by CUDA events if possible and
/// by fences otherwise, or returns none and sets `fault`.
template <class Blocks, class Space>
std::optional<Team<Space>> team_with(Mpi& mpi, std::string& fault) {
#ifdef KOKKOS_ENABLE_CUDA
  if constexpr (std::is_same_v<Space, Kokkos::Cuda>)
    if (auto team = team_with<Blocks, EventMark>(mpi, Space(), fault)) return team;
#endif
  return team_with<Blocks, FencedMark>(mpi, Space(), fault);
}

/// Returns the value of SCREE_TRANSPORT, or "" if it is not set. Throws std::runtime_error unless the value is allowed
/// and the same on all ranks; otherwise the ranks would wait for each other. All ranks call this function together.
inline std::string asked_transport(Mpi& mpi) {
  char const* const given = std::getenv("SCREE_TRANSPORT");
  std::string const asked = given == nullptr ? "" : given;
  std::array<char const*, 6> const allowed = {"", "peers", "host", "mpi", "gpu-mpi", "staged-mpi"};
  auto const found = std::find(allowed.begin(), allowed.end(), asked);
  if (found == allowed.end())
    throw std::runtime_error("scree: SCREE_TRANSPORT is '" + asked +
                             "'; allowed: peers, host, mpi, gpu-mpi, staged-mpi");
  auto const mine = static_cast<unsigned char>(found - allowed.begin());
  std::vector<unsigned char> all(std::size_t(mpi.ranks()));
  mpi.gather(&mine, 1, all.data());
  for (auto const each : all)
    if (each != mine)
      throw std::runtime_error("scree: SCREE_TRANSPORT is '" + asked + "' on one rank and '" + allowed[each] +
                               "' on another; set it alike on all hosts");
  return asked;
}

/// Returns a team of the MPI processes that exchanges messages by MPI. If that is impossible, returns none and sets
/// `fault` to the reason.
template <class Space>
std::optional<Team<Space>> team_by_mpi(MPI_Comm communicator, std::string const& asked, std::string& fault) {
  Mpi staged(communicator);
  fault = "only between GPUs";
  if constexpr (!on_host<Space>) {
    bool const may = asked == "gpu-mpi" || (asked != "staged-mpi" && all_say(staged, says_gpu_aware()));
    if (may && is_gpu_aware(communicator, Space())) return Team<Space>(Mpi(communicator, DeviceMessages::direct));
    fault = "messages between GPUs do not arrive whole";
  }
  if (asked == "gpu-mpi") return {};
  return Team<Space>(std::move(staged));
}

}  // namespace detail

/// Returns a team of the ranks of a communicator. GPUs on one host write to each other's memory (PeerMemory); if a test
/// shows that they cannot, messages go through host memory. All other ranks send messages by MPI: directly from GPU
/// memory if the library reports support and a test confirms it, and through host memory otherwise. The environment
/// variable SCREE_TRANSPORT selects one transport: `peers`, `host` (also for ranks without a GPU), `mpi`, `gpu-mpi`
/// (even if the library does not report support) or `staged-mpi`. Throws std::runtime_error if the selected transport
/// is impossible.
template <class Space>
Team<Space> team_of_mpi(MPI_Comm communicator = MPI_COMM_WORLD) {
  Mpi mpi(communicator);
  std::string const asked = detail::asked_transport(mpi);
  if (mpi.ranks() == 1) return Team<Space>(std::move(mpi));
  std::string fault = asked == "host" ? "only on Linux, between CPUs or NVIDIA GPUs" : "only between NVIDIA GPUs";
#ifdef KOKKOS_ENABLE_CUDA
  if constexpr (std::is_same_v<Space, Kokkos::Cuda>)
    if (asked.empty() || asked == "peers")
      if (auto team = detail::team_with<CudaBlocks, Space>(mpi, fault)) return *team;
#endif
#ifdef __linux__
  if constexpr (HostBlocks::serves<Space>)
    if (asked == "host" || (asked.empty() && !on_host<Space>))
      if (auto team = detail::team_with<HostBlocks, Space>(mpi, fault)) return *team;
#endif
  if (asked != "host" && asked != "peers")
    if (auto team = detail::team_by_mpi<Space>(communicator, asked, fault)) return *team;
  throw std::runtime_error("scree: SCREE_TRANSPORT=" + asked + " is not possible: " + fault);
}

/// Calls function(team, space) with the ranks of MPI_COMM_WORLD. If the function throws on any rank, the message is
/// printed to stderr and all processes end. MPI and Kokkos must have been initialised; Kokkos chooses the device of a
/// rank by the number of the rank on its host.
template <class Space, class Function>
void run_on_mpi(Function const& function) {
  Mpi mpi;
  detail::LetWriteFiles const here{mpi.rank() == 0};
  try {
    function(team_of_mpi<Space>(), Space());
  } catch (std::exception const& error) {
    mpi.fail(error.what());
  } catch (...) {
    mpi.fail("unknown error");
  }
}

}  // namespace scree

#endif
