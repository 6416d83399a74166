// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/share_of_rank.hpp"
#include "../core/types.hpp"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace scree {

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

/// Returns the share of one rank of points that are known on every rank.
template <int Dim>
SharedPoints<Dim> share_of(std::vector<Vec<Dim, double>> const& points, ShareOfRank const& share) {
  share.check();
  long const all = static_cast<long>(points.size()), first = share.first_of(all);
  return {{points.begin() + first, points.begin() + share.end_of(all)}, first, all};
}

}  // namespace scree
