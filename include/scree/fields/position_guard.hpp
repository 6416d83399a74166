// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "array.hpp"

#include <limits>

namespace scree::detail {

/// Whether steps may be taken before it is known that neighbour lists serve: on a GPU, where a wait costs more than to
/// repeat steps now and then. On a host for tests only.
#ifdef SCREE_TRIALS_ON_HOST
template <class Space>
inline constexpr bool has_trials = true;
#else
template <class Space>
inline constexpr bool has_trials = !on_host<Space>;
#endif

/// Notes which update first moved a particle of a body too far from where neighbour lists were built. Loops that write
/// positions ask it for each particle; the host reads the note from its own memory, without a copy.
template <class P>
struct PositionGuard {
  using vector = Vec<P::dim, typename P::real>;
  static constexpr int none = std::numeric_limits<int>::max();

  ArraySpan<P, vector const> kept;       // m
  typename P::real squared_limit = 0;    // m^2
  int volatile* first_beyond = nullptr;  // number of an update, or `none`
  int update = 0;                        // the number of the next one

  /// Where particle i was when lists were built. Load it before results are stored: a load waits for stores.
  SCREE_FN vector start(int i) const { return first_beyond == nullptr ? zero<vector>() : value_of(kept(i)); }
  SCREE_FN void look(vector const& from, vector const& to) const {
    if (first_beyond == nullptr || squared_norm(to - from) <= squared_limit) return;
    if (*first_beyond == none) *first_beyond = update;  // kernels run in order, and all threads write the same
  }
};

}  // namespace scree::detail
