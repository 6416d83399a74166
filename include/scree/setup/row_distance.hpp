// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "shapes/shape.hpp"

#include <cmath>
#include <limits>

namespace scree::detail {

/// The signed distance from a shape at points of rows along the first axis, exact enough to compare it with two limits.
/// A signed distance has a slope of one at most, so that points within a row need not be computed as long as they
/// cannot have come to a limit.
template <Shape S>
class RowDistance {
 public:
  RowDistance(S const& shape, double first_limit, double second_limit)
      : shape_(shape), limits_{first_limit, second_limit} {}

  double operator()(Vec<S::dim, double> const& x) {
    if constexpr (is_costly<S>) {
      if (is_known(x)) return distance_;
      x_ = x;
    }
    return distance_ = shape_.signed_distance(x);
  }

 private:
  bool is_known(Vec<S::dim, double> const& x) const {
    for (int axis = 1; axis < S::dim; ++axis)
      if (!(x[axis] == x_[axis])) return false;
    double const moved = std::abs(x[0] - x_[0]) * (1 + 1e-9);
    return std::abs(distance_ - limits_[0]) > moved && std::abs(distance_ - limits_[1]) > moved;
  }
  S const& shape_;
  double limits_[2];
  double distance_ = 0;
  Vec<S::dim, double> x_ = Vec<S::dim, double>::Constant(std::numeric_limits<double>::quiet_NaN());
};

}  // namespace scree::detail
