// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"
#include "../fields/groups.hpp"

#include <vector>

namespace scree {

/// Returns points in another precision.
template <class Real, int Dim>
std::vector<Vec<Dim, Real>> cast(std::vector<Vec<Dim, double>> const& points) {
  std::vector<Vec<Dim, Real>> result;
  result.reserve(points.size());
  for (auto const& x : points) {
    auto& same = result.emplace_back();
    for (int axis = 0; axis < Dim; ++axis) same[axis] = Real(x[axis]);
  }
  return result;
}
// If the argument consists of groups, the compiler explains that they need no cast.
template <class Real, int Dim>
Groups<Dim> const& cast(Groups<Dim> const& groups) {
  static_assert(Dim < 0,
                "groups need no cast, also for Formulation<2, float>: a solver takes them as they are, and converts "
                "their points");
  return groups;
}

}  // namespace scree
