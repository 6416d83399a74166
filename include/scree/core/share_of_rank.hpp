// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "setting.hpp"

#include <concepts>

namespace scree {

/// The share of the points of a case that belongs to one rank. Team::share() returns it.
struct ShareOfRank {
  int rank = 0, ranks = 1;  ///< the number of the rank, from 0, and the number of ranks

  /// Throws std::invalid_argument unless 0 <= rank < ranks.
  void check() const {
    check_setting(ranks > 0, "the number of shares", ranks, "1 or more");
    check_setting(rank >= 0 && rank < ranks, "the number of a share", rank, "from 0, below the number of shares");
  }
  /// Returns the number of the first of `all` points that belongs to this share. The next share starts directly after
  /// the last point of this share. The sizes of shares differ by at most one point.
  long first_of(long all) const { return all / ranks * rank + all % ranks * rank / ranks; }
  /// Returns the number after the last of `all` points that belongs to this share.
  long end_of(long all) const { return ShareOfRank{rank + 1, ranks}.first_of(all); }
};
/// Whether a type is ShareOfRank. Functions that take a share use this concept, so that coordinates in braces do not
/// convert to a share.
template <class T>
concept IsShareOfRank = std::same_as<T, ShareOfRank>;

}  // namespace scree
