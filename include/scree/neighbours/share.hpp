// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/columns.hpp"

// How the threads of a GPU share the neighbours of a particle.
namespace scree {

/// A part of the candidates of one target: every `lanes`-th from the `lane`-th on.
struct Share {
  int lane = 0, lanes = 1;
};

/// Whether loops run where the host's memory is.
template <class P>
inline constexpr bool runs_on_host = Kokkos::SpaceAccessibility<Kokkos::HostSpace, memory_of<P>>::accessible;

/// Threads per target: a GPU that has fewer targets than threads waits for memory most of the time. A constant decides,
/// not the device at hand, so that the order of summation is the same on all.
template <class P>
int lanes_for(int targets) {
  constexpr int threads = 1 << 18, most = 8;
  int lanes = 1;
  while (!runs_on_host<P> && lanes < most && 2 * lanes * targets <= threads) lanes *= 2;
  return lanes;
}

}  // namespace scree
