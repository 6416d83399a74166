// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

namespace scree::bench {

/// The options of bench_ranks.
struct Plan {
  double particles = 100'000;      // of the case, or of each rank
  bool per_rank = false;           // weak scaling: ranks follow each other along x
  double length = 1, shear = 0.5;  // of the case or of a rank, m; 1/s
  int ranks = 1;                   // threads, without mpirun
  int steps = 50, warm_up = 30, repetitions = 5;
  bool hash = false;        // of the state at the end
  bool divided = false;     // each rank begins with its share of the particles
  bool large = false;       // lists of more than 2^32 candidates, in float
  bool memory = false;      // print the peaks of memory
  bool one_process = true;  // ranks are threads
  bool in_float = true, in_double = true;
};

}  // namespace scree::bench
