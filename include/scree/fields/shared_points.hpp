// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../core/types.hpp"

#include <concepts>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

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

/// The consecutive points of a filling that one rank of a case has at its start. Point k of the share is point number
/// `first + k` of the `all` points of the filling. Each number must be in the share of exactly one rank.
template <int Dim>
struct SharedPoints {
  std::vector<Vec<Dim, double>> points;  ///< m
  long first = 0, all = 0;               ///< the number of the first point, and the number of points of the filling

  /// Throws std::invalid_argument unless the share lies within the `all` points of the filling.
  void check() const {
    if (first < 0 || first + static_cast<long>(points.size()) > all)
      throw std::invalid_argument("set-up: a share of " + std::to_string(points.size()) + " points from number " +
                                  std::to_string(first) + " on is not within the " + std::to_string(all) +
                                  " points of its filling: see `first` and `all` of SharedPoints");
  }
};

namespace detail {
/// Throws std::invalid_argument if a case without ranks is given only a share of some points.
[[gnu::cold]] inline void require_all_points(long here, long all) {
  if (here != all)
    throw std::invalid_argument(
        formatted("scree: a share of %ld of %ld points is given, and the solver has no ranks: make it a "
                  "Solver<OnRanks<F>>, or give all points",
                  here, all));
}
}  // namespace detail

/// Returns the share of one rank of points that are known on every rank.
template <int Dim>
SharedPoints<Dim> share_of(std::vector<Vec<Dim, double>> const& points, ShareOfRank const& share) {
  share.check();
  long const all = static_cast<long>(points.size()), first = share.first_of(all);
  return {{points.begin() + first, points.begin() + share.end_of(all)}, first, all};
}

}  // namespace scree
