// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/space.hpp"

// How the threads of a GPU share the neighbours of a particle.
namespace scree {

/// The candidates of one target that one lane visits: every `lanes`-th candidate, starting with number `lane`.
struct LaneRange {
  int lane = 0, lanes = 1;
};

/// Returns the number of threads (lanes) per target; on a host it is 1. A GPU with fewer targets than threads would
/// mostly wait for memory. In 3D, rows are long, and four threads that read one row together need fewer cache lines
/// than four threads that read one row each. The number depends on constants and not on the device, so that the order
/// of summation is the same on all GPUs.
template <class P>
int lanes_for(long targets) {
  constexpr int threads = 1 << 18, least = P::dim == 3 ? 4 : 1, most = 8;
  if (runs_on_host<P>) return 1;
  int lanes = least;
  while (lanes < most && 2 * lanes * targets <= threads) lanes *= 2;
  return lanes;
}

}  // namespace scree
