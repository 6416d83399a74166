// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "setting.hpp"

#include <concepts>

namespace scree {

/// The share of one rank, counted from 0, in the points of a case. Team::share() gives it.
struct ShareOfRank {
  int rank = 0, ranks = 1;  ///< the number of the rank, from 0, and of all ranks

  /// Throws std::invalid_argument unless there is such a rank.
  void check() const {
    check_setting(ranks > 0, "the number of shares", ranks, "1 or more");
    check_setting(rank >= 0 && rank < ranks, "the number of a share", rank, "from 0, below the number of shares");
  }
  /// The first of `all` points that belongs to this share; that of the next share follows its last one. Shares differ
  /// by one point at most.
  long first_of(long all) const { return all / ranks * rank + all % ranks * rank / ranks; }
  /// The number after the last point of this rank, of `all` points.
  long end_of(long all) const { return ShareOfRank{rank + 1, ranks}.first_of(all); }
};
/// Functions take a share under this concept, because braces around coordinates must not become a share.
template <class T>
concept IsShareOfRank = std::same_as<T, ShareOfRank>;

}  // namespace scree
