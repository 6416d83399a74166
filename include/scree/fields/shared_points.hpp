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

/// Some consecutive points of a filling, those that one rank of a case has at its start. Point k here is number
/// `first + k` of the `all` points of the filling. The shares of all ranks have each number once.
template <int Dim>
struct SharedPoints {
  std::vector<Vec<Dim, double>> points;  ///< m
  long first = 0, all = 0;               ///< the number of the first point among all, and the number of all points

  /// Throws std::invalid_argument unless the points are among all.
  void check() const {
    if (first < 0 || first + static_cast<long>(points.size()) > all)
      throw std::invalid_argument("set-up: a share of " + std::to_string(points.size()) + " points from number " +
                                  std::to_string(first) + " on is not within the " + std::to_string(all) +
                                  " points of its filling: see `first` and `all` of SharedPoints");
  }
};

namespace detail {
/// Throws std::invalid_argument if only a share of some points is here, for a case without ranks.
[[gnu::cold]] inline void require_all_points(long here, long all) {
  if (here != all)
    throw std::invalid_argument(
        formatted("scree: a share of %ld of %ld points is given, and the solver has no ranks: make it a "
                  "Solver<OnRanks<F>>, or give all points",
                  here, all));
}
}  // namespace detail

/// A share of points that each rank has.
template <int Dim>
SharedPoints<Dim> share_of(std::vector<Vec<Dim, double>> const& points, ShareOfRank const& share) {
  share.check();
  long const all = static_cast<long>(points.size()), first = share.first_of(all);
  return {{points.begin() + first, points.begin() + share.end_of(all)}, first, all};
}

}  // namespace scree
