// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "array.hpp"

#include <limits>

namespace scree::detail {

/// Whether steps may run before it is known that the neighbour lists are valid. The value is true on a GPU, where
/// waiting costs more than occasionally repeating steps, and on a host only for tests.
#ifdef SCREE_TRIALS_ON_HOST
template <class Space>
inline constexpr bool has_trials = true;
#else
template <class Space>
inline constexpr bool has_trials = !on_host<Space>;
#endif

/// A record of the first update that moved a particle of a body too far from its position at the last build of the
/// neighbour lists. Loops that write positions check each particle; the host reads the record from its own memory,
/// without a copy.
template <class P>
struct PositionGuard {
  using vector = Vec<P::dim, typename P::real>;
  static constexpr int none = std::numeric_limits<int>::max();

  ArraySpan<P, vector const> kept;       ///< positions at the last build, m
  typename P::real squared_limit = 0;    ///< square of the largest valid displacement, m^2
  int volatile* first_beyond = nullptr;  ///< number of an update, or `none`
  int update = 0;                        ///< number of the next update

  /// Returns the position of particle i at the last build of the lists, or zero if the guard is inactive. Call this
  /// function before results are stored, because a load waits for stores.
  SCREE_FN vector start(int i) const { return first_beyond == nullptr ? zero<vector>() : value_of(kept(i)); }
  SCREE_FN void look(vector const& from, vector const& to) const {
    if (first_beyond == nullptr || squared_norm(to - from) <= squared_limit) return;
    if (*first_beyond == none) *first_beyond = update;  // kernels run in order, and all threads write the same value
  }
};

}  // namespace scree::detail
