// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/share_of_part.hpp"
#include "../core/types.hpp"

#include <cstddef>
#include <vector>

namespace scree {

/// Some consecutive points of a filling, those that one part of a case has at its start. Point k here is number
/// `first + k` of the `all` points of the filling. The shares of all parts have each number once.
template <int Dim>
struct SharedPoints {
  std::vector<Vec<Dim, double>> points;  // m
  long first = 0, all = 0;
};

/// A share of points that each part has.
template <int Dim>
SharedPoints<Dim> share_of(std::vector<Vec<Dim, double>> const& points, ShareOfPart const& share) {
  share.check();
  long const all = static_cast<long>(points.size()), first = share.first_of(all);
  return {{points.begin() + first, points.begin() + share.end_of(all)}, first, all};
}

}  // namespace scree
