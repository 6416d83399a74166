// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/instances.hpp"
#include "../core/setting.hpp"
#include "../core/writes_files.hpp"
#include "shared_memory.hpp"
#include "team.hpp"

#include <cstddef>
#include <exception>
#include <string>
#include <thread>
#include <vector>

namespace scree {

/// Calls function(team, space) for each rank in its own thread of this process and with its own execution space
/// instance; on a CPU the instances share the threads. Returns when all ranks have ended. If a rank throws, all ranks
/// end, and its exception is rethrown here; if several throw, the exception of the lowest rank is rethrown.
template <class Space, class Function>
void run_on_threads(int ranks, Function const& function) {
  check_setting(ranks > 0, "the number of ranks", ranks, "1 or more");
  auto const instances = instances_of<Space>(ranks);
  auto const ends = SharedMemory::ends(ranks);
  std::vector<std::exception_ptr> failures(ends.size()), followed(ends.size());
  auto const run = [&](std::size_t rank) {
    detail::LetWriteFiles const here{rank == 0};
    SharedMemory end = ends[rank];
    try {
      function(Team<Space>(end), instances[rank]);
      end.leave();
    } catch (OtherRankFailed const&) {
      followed[rank] = std::current_exception();
    } catch (std::exception const& error) {
      failures[rank] = std::current_exception();
      end.fail(error.what());
    } catch (...) {
      failures[rank] = std::current_exception();
      end.fail("unknown error");
    }
  };
  std::vector<std::thread> threads;
  for (std::size_t rank = 1; rank < ends.size(); ++rank) threads.emplace_back(run, rank);
  run(0);
  for (std::thread& thread : threads) thread.join();
  for (auto const& each : {failures, followed})
    for (std::exception_ptr const& failure : each)
      if (failure) std::rethrow_exception(failure);
}

}  // namespace scree
