// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

// Measurements of the ranks of a case: plain data, which travel as bytes.
namespace scree {

/// Calls of the functions of a Team on one rank, since it was made. Times include waiting for other ranks.
struct Traffic {
  std::int64_t exchanges = 0, gathers = 0;
  std::int64_t messages = 0, bytes = 0;  ///< that exchanges sent to other ranks
  double exchanging = 0, gathering = 0;  ///< time in these calls, s
};

/// Counts and times of one rank during some steps. A case without ranks has one.
struct RankProfile {
  std::int64_t particles = 0, ghosts = 0;  ///< of all bodies, at the end
  std::int64_t steps = 0, builds = 0;      ///< steps, and builds of lists
  std::int64_t migrated = 0;               ///< particles that came from other ranks
  double seconds = 0;                      ///< wall-clock time, s
  Traffic traffic = {};
};

/// Latency and bandwidth of messages when each rank sends one to the next: values of the slowest rank.
struct Link {
  double latency = 0;    ///< of a message of 8 bytes, s
  double bandwidth = 0;  ///< of messages of 16 MiB, bytes/s
};

/// The host and device of a rank.
struct Place {
  char host[64] = {};
  char device[64] = {};  ///< name of the GPU; empty on a host
  int number = 0;        ///< of the GPU on its host
  int threads = 0;       ///< of the host, where there is no GPU
};

}  // namespace scree
