// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "shapes/shape.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace scree::detail {

/// The signed distance from a shape for points that are visited in rows along the first axis, accurate enough for a
/// comparison with two limits. The slope of a signed distance is at most one. The distance is therefore not computed at
/// points where its value at the preceding point, or at a point of the preceding row, shows that no limit can have been
/// crossed. Each thread needs its own object.
template <Shape S>
class RowDistance {
 public:
  RowDistance(S const& shape, double first_limit, double second_limit)
      : walk_(walk(shape)), has_jumps_(has_jumps(shape)), limits_{first_limit, second_limit} {}

  double operator()(Vec<S::dim, double> const& x) {
    if constexpr (!is_costly<S>) return walk_(x);
    if (!is_in_row(x)) {
      std::swap(row_, row_before_);
      row_.clear(), beside_ = 0;
    }
    Known known = row_.empty() ? Known{} : moved(row_.back(), x);
    while (beside_ < row_before_.size() && row_before_[beside_].x[0] < x[0]) ++beside_;
    if (beside_ < row_before_.size() && !has_jumps_) known = better(known, moved(row_before_[beside_], x));
    if (!(margin(known) > 0)) known = {x, walk_(x), 0};
    row_.push_back(known);
    return known.distance;
  }

 private:
  /// A point x at which the signed distance differs from `distance` by at most `error`, m.
  struct Known {
    Vec<S::dim, double> x = Vec<S::dim, double>::Zero();
    double distance = 0, error = std::numeric_limits<double>::infinity();
  };
  bool is_in_row(Vec<S::dim, double> const& x) const {
    if (row_.empty() || !(x[0] >= row_.back().x[0])) return false;
    for (int axis = 1; axis < S::dim; ++axis)
      if (!(x[axis] == row_.back().x[axis])) return false;
    return true;
  }
  static Known moved(Known const& from, Vec<S::dim, double> const& x) {
    return {x, from.distance, from.error + (x - from.x).norm() * (1 + 1e-9)};
  }
  /// Returns a lower bound on the difference between the signed distance of a point and either limit, m.
  double margin(Known const& known) const {
    return std::min(std::abs(known.distance - limits_[0]), std::abs(known.distance - limits_[1])) - known.error;
  }
  Known const& better(Known const& one, Known const& other) const { return margin(one) < margin(other) ? other : one; }

  decltype(walk(std::declval<S const&>())) walk_;
  bool has_jumps_;
  double limits_[2];
  std::vector<Known> row_, row_before_;
  std::size_t beside_ = 0;  // first point of the preceding row that is not before the present point
};

}  // namespace scree::detail
