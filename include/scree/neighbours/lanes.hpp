// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/space.hpp"

// How the threads of a GPU share the neighbours of a particle.
namespace scree {

/// The candidates of one target that one lane visits: every `lanes`-th one, starting at `lane`.
struct LaneRange {
  int lane = 0, lanes = 1;
};

/// Threads per target: a GPU with fewer targets than threads mostly waits for memory. In 3D rows are long, and four
/// threads that read one row together need fewer cache lines than four rows do. Constants, not the device, set this
/// number, so that the order of summation is the same on all GPUs.
template <class P>
int lanes_for(long targets) {
  constexpr int threads = 1 << 18, least = P::dim == 3 ? 4 : 1, most = 8;
  if (runs_on_host<P>) return 1;
  int lanes = least;
  while (lanes < most && 2 * lanes * targets <= threads) lanes *= 2;
  return lanes;
}

}  // namespace scree
