// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/types.hpp"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace scree::detail {

/// Returns the area of the parallelogram of two vectors, positive if b is to the left of a.
inline double area_between(Vec<2, double> const& a, Vec<2, double> const& b) { return a[0] * b[1] - a[1] * b[0]; }

/// Whether x is in a counter-clockwise triangle or on its sides.
inline bool is_in_triangle(std::array<Vec<2, double>, 3> const& abc, Vec<2, double> const& x) {
  for (std::size_t k = 0; k < 3; ++k)
    if (area_between(abc[(k + 1) % 3] - abc[k], x - abc[k]) < 0) return false;
  return true;
}

/// Returns the corners of a polygon in space, projected onto the plane in which its area is largest (perpendicular to
/// Newell's normal), counter-clockwise. The result is empty if the polygon crosses itself so that its area is zero.
inline std::vector<Vec<2, double>> in_own_plane(std::vector<Vec<3, double>> const& polygon) {
  Vec<3, double> normal = Vec<3, double>::Zero();
  double size = 0, length = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    Vec<3, double> const to = polygon[k] - polygon[0], next = polygon[(k + 1) % polygon.size()] - polygon[0];
    normal += to.cross(next);
    size += to.cross(next).norm(), length += (next - to).norm();
  }
  if (size > 1e-12 * sq(length) && normal.norm() <= 1e-12 * sq(length)) return {};
  int axis = 0;
  normal.cwiseAbs().minCoeff(&axis);
  Vec<3, double> const n = normal.normalized(), u = n.cross(Vec<3, double>::Unit(axis)).normalized(), v = n.cross(u);
  std::vector<Vec<2, double>> result;
  for (auto const& x : polygon) result.push_back({(x - polygon[0]).dot(u), (x - polygon[0]).dot(v)});
  return result;
}

/// Cuts a simple polygon into triangles, given as places of its corners. Ears, the corners that can be cut off without
/// touching another one, are removed one after the other, those without area last. The time is at most proportional to
/// the third power of the number of corners. Returns fewer triangles than the number of corners minus two if the
/// polygon crosses itself.
inline std::vector<std::array<std::size_t, 3>> clip_ears(std::vector<Vec<3, double>> const& polygon) {
  auto const x = in_own_plane(polygon);
  std::vector<std::size_t> left(x.size());
  for (std::size_t k = 0; k < left.size(); ++k) left[k] = k;
  std::vector<std::array<std::size_t, 3>> triangles;
  auto const is_ear = [&](std::array<std::size_t, 3> const& abc, bool flat) {
    std::array<Vec<2, double>, 3> const ear{x[abc[0]], x[abc[1]], x[abc[2]]};
    double const rounding = 1e-12 * (ear[1] - ear[0]).norm() * (ear[2] - ear[1]).norm();
    double const twice_area = area_between(ear[1] - ear[0], ear[2] - ear[0]);
    if (flat && std::abs(twice_area) <= rounding) return true;
    if (!(twice_area > rounding)) return false;
    for (std::size_t const other : left) {
      if (other == abc[0] || other == abc[1] || other == abc[2]) continue;
      if (x[other] == ear[0] || x[other] == ear[1] || x[other] == ear[2]) continue;
      if (is_in_triangle(ear, x[other])) return false;
    }
    return true;
  };
  auto const cut_one = [&](bool flat) {
    std::size_t const count = left.size();
    for (std::size_t k = 0; k < count; ++k) {
      std::array<std::size_t, 3> const abc{left[(k + count - 1) % count], left[k], left[(k + 1) % count]};
      if (count > 3 && !is_ear(abc, flat)) continue;
      triangles.push_back(abc);
      left.erase(left.begin() + std::ptrdiff_t(k));
      return true;
    }
    return false;
  };
  while (left.size() >= 3 && (cut_one(false) || cut_one(true))) {
  }
  return triangles;
}

}  // namespace scree::detail
