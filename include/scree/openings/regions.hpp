// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"
#include "../fields/standard.hpp"

// Conditions on the position of a particle, for drains and for Solver::remove().
namespace scree {

/// Beyond a plane, on the side of its normal.
template <int Dim>
struct Beyond {
  using reads = Fields<Position>;
  Vec<Dim, double> point;   ///< of the plane, m
  Vec<Dim, double> normal;  ///< of any length
  template <class I>
  SCREE_FN bool operator()(I const& i) const {
    double distance = 0;
    for (int axis = 0; axis < Dim; ++axis) distance += (double(i[fields::position][axis]) - point[axis]) * normal[axis];
    return distance > 0;
  }
};
/// In a block aligned with the axes. Its edges may be at infinity.
template <int Dim>
struct Within {
  using reads = Fields<Position>;
  Vec<Dim, double> low, high;  ///< m
  template <class I>
  SCREE_FN bool operator()(I const& i) const {
    using namespace fields;
    for (int axis = 0; axis < Dim; ++axis)
      if (!(i[position][axis] > low[axis] && i[position][axis] < high[axis])) return false;
    return true;
  }
};

}  // namespace scree
