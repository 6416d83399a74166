// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

// Measurements on the ranks of a case: plain data that can be sent as bytes.
namespace scree {

/// Calls to the functions of a Team on one rank since the team was constructed. Times include waiting for other ranks.
struct Traffic {
  std::int64_t exchanges = 0, gathers = 0;
  std::int64_t messages = 0, bytes = 0;  ///< sent to other ranks by exchanges
  double exchanging = 0, gathering = 0;  ///< time in exchanges and in gathers, s
};

/// Counts and times of one rank during some steps. A case that is not divided among ranks has one profile.
struct RankProfile {
  std::int64_t particles = 0, ghosts = 0;  ///< of all bodies, at the end
  std::int64_t steps = 0, builds = 0;      ///< steps, and builds of neighbour lists
  std::int64_t migrated = 0;               ///< particles received for good from other ranks
  double seconds = 0;                      ///< wall-clock time, s
  Traffic traffic = {};
};

/// Latency and bandwidth of messages when each rank sends one to the next, on the slowest rank.
struct Link {
  double latency = 0;    ///< of a message of 8 bytes, s
  double bandwidth = 0;  ///< of messages of 16 MiB, bytes/s
};

/// The host and device of a rank.
struct Place {
  char host[64] = {};
  char device[64] = {};  ///< name of the GPU; empty for a CPU
  int number = 0;        ///< number of the GPU on its host
  int threads = 0;       ///< number of CPU threads, if there is no GPU
};

}  // namespace scree
