// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../core/types.hpp"
#include "../fields/standard.hpp"

#include <cmath>
#include <string>

// Conditions on the position of a particle, for drains and for Solver::remove().
namespace scree {

/// The region beyond a plane, on the side to which its normal points.
template <int Dim>
struct Beyond {
  using reads = Fields<Position>;
  Vec<Dim, double> point;   ///< point of the plane, m
  Vec<Dim, double> normal;  ///< of any length above 0

  /// Throws std::invalid_argument if the point and the normal do not define a plane.
  void check() const {
    check_setting(point.allFinite(), "point of Beyond (m)", point.sum(), "finite");
    double const length = normal.norm();
    check_setting(length > 0 && std::isfinite(length), "length of the normal of Beyond", length, "above 0");
  }
  template <class I>
  SCREE_FN bool operator()(I const& i) const {
    double distance = 0;
    for (int axis = 0; axis < Dim; ++axis) distance += (double(i[fields::position][axis]) - point[axis]) * normal[axis];
    return distance > 0;
  }
};
/// The region inside a block that is aligned with the axes. The faces of the block may be at infinity.
template <int Dim>
struct Within {
  using reads = Fields<Position>;
  Vec<Dim, double> low, high;  ///< m

  /// Throws std::invalid_argument if the block is empty.
  void check() const {
    for (int axis = 0; axis < Dim; ++axis)
      check_setting(low[axis] < high[axis], detail::formatted("high (m) of Within along axis %d", axis).c_str(),
                    high[axis], ("above its low, " + detail::short_text(low[axis])).c_str());
  }
  template <class I>
  SCREE_FN bool operator()(I const& i) const {
    using namespace fields;
    for (int axis = 0; axis < Dim; ++axis)
      if (!(i[position][axis] > low[axis] && i[position][axis] < high[axis])) return false;
    return true;
  }
};

}  // namespace scree
