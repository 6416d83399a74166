// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/available_memory.hpp"
#include "triangles.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

namespace scree::detail {

/// An edge of a triangle, from its corner `corner` to the next one.
struct Side {
  int low, high;  ///< vertices, in ascending order
  int triangle, corner;
  bool forwards;  ///< whether it runs from `low` to `high`
};

/// Returns the sides of all triangles, sorted so that the sides of one edge are next to each other.
inline std::vector<Side> sides_of(Triangles const& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.size());
  for (std::size_t t = 0; t < mesh.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      int const a = mesh.corners[t][k], b = mesh.corners[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), int(t), int(k), a < b});
    }
  std::sort(sides.begin(), sides.end(), [](Side const& a, Side const& b) {
    return std::tie(a.low, a.high, a.triangle, a.corner) < std::tie(b.low, b.high, b.triangle, b.corner);
  });
  return sides;
}

/// The connections of triangles across edges. Where shells touch, an edge has more than two triangles: these are
/// ordered around the edge, and each triangle at which the inside begins is joined with the one at which it ends.
struct Edges {
  static constexpr int none = -1;
  struct Across {
    int triangle = none;
    bool same_direction = false;  // both triangles run along the edge in the same direction: one of them is turned over
  };
  std::vector<std::array<Across, 3>> across;  ///< the triangle across each side of each triangle
  std::vector<int> open, crowded;             ///< a triangle at each edge that has only one, or more than two

  explicit Edges(Triangles const& mesh) : across(mesh.size()) {
    auto const sides = sides_of(mesh);
    for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
      while (last < sides.size() && sides[last].low == sides[first].low && sides[last].high == sides[first].high)
        ++last;
      Side const& a = sides[first];
      if (last - first == 1) open.push_back(a.triangle);
      if (last - first == 2) join(a, sides[last - 1]);
      if (last - first <= 2) continue;
      crowded.push_back(a.triangle);
      join_around(mesh, {sides.begin() + long(first), sides.begin() + long(last)});
    }
  }

 private:
  void join(Side const& one, Side const& other) {
    bool const same_direction = one.forwards == other.forwards;
    across[std::size_t(one.triangle)][std::size_t(one.corner)] = {other.triangle, same_direction};
    across[std::size_t(other.triangle)][std::size_t(other.corner)] = {one.triangle, same_direction};
  }
  /// Joins the sides of an edge that has more than two triangles, if equal numbers of them run forwards and backwards.
  /// In a counter-clockwise turn about the edge, the inside begins at a side that runs backwards and ends at one that
  /// runs forwards. Sides with the same angle and direction are joined in the order of their triangles in the file.
  void join_around(Triangles const& mesh, std::vector<Side> sides) {
    long const forwards = std::count_if(sides.begin(), sides.end(), [](Side const& side) { return side.forwards; });
    if (2 * forwards != long(sides.size())) return;
    auto const angles = angles_around(mesh, sides);
    std::vector<std::size_t> order(sides.size()), begun, ended;
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      if (angles[a] != angles[b]) return angles[a] < angles[b];
      if (sides[a].forwards != sides[b].forwards) return sides[a].forwards;
      return sides[a].forwards ? a < b : a > b;
    });
    for (std::size_t const k : order) {
      if (!sides[k].forwards) {
        begun.push_back(k);
      } else if (begun.empty()) {
        ended.push_back(k);  // its inside began before the first angle
      } else {
        join(sides[begun.back()], sides[k]);
        begun.pop_back();
      }
    }
    for (std::size_t const k : ended) {
      join(sides[begun.back()], sides[k]);
      begun.pop_back();
    }
  }
  /// Returns the angle of each triangle about its edge, counter-clockwise from the first triangle, rad. Angles that
  /// differ by less than 1e-6 are made equal.
  static std::vector<double> angles_around(Triangles const& mesh, std::vector<Side> const& sides) {
    auto const& from = mesh.vertices[std::size_t(sides[0].low)];
    Vec<3, double> const along = (mesh.vertices[std::size_t(sides[0].high)] - from).normalized();
    auto const tip_of = [&](Side const& side) {
      Vec<3, double> const tip = mesh.vertex(std::size_t(side.triangle), std::size_t(side.corner + 2) % 3) - from;
      return Vec<3, double>(tip - tip.dot(along) * along);
    };
    Vec<3, double> const start = tip_of(sides[0]), beside = along.cross(start);
    std::vector<double> angles;
    for (Side const& side : sides) {
      Vec<3, double> const tip = tip_of(side);
      double angle = std::atan2(tip.dot(beside), tip.dot(start));
      if (angle < -5e-7) angle += 2 * std::numbers::pi;
      for (double const known : angles)
        if (std::abs(angle - known) < 1e-6) angle = known;
      angles.push_back(angle);
    }
    return angles;
  }
};

/// Whether the triangles have no border: they run along each edge equally often in both directions.
inline bool is_closed(Triangles const& mesh) {
  auto const sides = sides_of(mesh);
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    int sum = 0;
    for (; last < sides.size() && sides[last].low == sides[first].low && sides[last].high == sides[first].high; ++last)
      sum += sides[last].forwards ? 1 : -1;
    if (sum != 0) return false;
  }
  return true;
}

}  // namespace scree::detail
