// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/instances.hpp"
#include "../core/setting.hpp"
#include "../core/this_part.hpp"
#include "shared_memory.hpp"
#include "team.hpp"

#include <cstddef>
#include <exception>
#include <string>
#include <thread>
#include <vector>

namespace scree {

/// Calls function(team, space) for each part in a thread of this process, each with an instance of the execution space
/// of its own; on a host they share the threads. Returns when all have ended. If one throws, all end, and its exception
/// is thrown here, that of the part with the lowest number if there are several.
template <class Space, class Function>
void run_on_parts(int parts, Function const& function) {
  check_setting(parts > 0, "the number of parts", parts, "1 or more");
  auto const instances = instances_of<Space>(parts);
  auto const ends = SharedMemory::ends(parts);
  std::vector<std::exception_ptr> failures(ends.size()), followed(ends.size());
  auto const run = [&](std::size_t part) {
    detail::OnThisPart const here{int(part)};
    SharedMemory end = ends[part];
    try {
      function(Team<Space>(end), instances[part]);
      end.leave();
    } catch (OtherPartFailed const&) {
      followed[part] = std::current_exception();
    } catch (std::exception const& error) {
      failures[part] = std::current_exception();
      end.fail(error.what());
    } catch (...) {
      failures[part] = std::current_exception();
      end.fail("unknown error");
    }
  };
  std::vector<std::thread> threads;
  for (std::size_t part = 1; part < ends.size(); ++part) threads.emplace_back(run, part);
  run(0);
  for (std::thread& thread : threads) thread.join();
  for (auto const& each : {failures, followed})
    for (std::exception_ptr const& failure : each)
      if (failure) std::rethrow_exception(failure);
}

}  // namespace scree
