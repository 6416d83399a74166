// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../shapes/shape.hpp"
#include "triangles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace scree {

/// Returns the box around triangles, m. There must be at least one triangle.
inline Box<3> bounds_of(Triangles const& mesh) {
  Box<3> box{mesh.vertex(0, 0), mesh.vertex(0, 0)};
  for (std::size_t t = 0; t < mesh.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) box = detail::hull(box, Box<3>{mesh.vertex(t, k), mesh.vertex(t, k)});
  return box;
}

namespace detail {

/// The smallest distance between separate parts of a surface, and the distance at which points in front of the surface
/// and behind it are probed, both relative to the largest extent of the mesh. 1e-7 is the rounding error of the
/// single-precision numbers of a binary STL file.
inline constexpr double apart_at_least = 1e-7, probe_depth = 2 * apart_at_least;

/// A table of the cubes of a grid that contain points, each with the number of the first point in it.
class CubeTable {
 public:
  CubeTable(Vec<3, double> const& low, double edge, std::size_t points) : low_(low), edge_(edge) {
    first_.reserve(points);
  }

  /// Returns the number of the first point whose distance from x along each axis is at most one edge; if there is none,
  /// adds x as point `number` and returns `number`.
  int find_or_add(Vec<3, double> const& x, int number, std::vector<Vec<3, double>> const& points) {
    std::array<std::int64_t, 3> cube{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      cube[axis] = std::int64_t(std::floor((x[int(axis)] - low_[int(axis)]) / edge_));
    auto const here = first_.find(cube);
    if (here != first_.end()) return here->second;  // no two points of a cube are farther apart than its edge
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy)
        for (std::int64_t dz = -1; dz <= 1; ++dz) {
          auto const found = first_.find({cube[0] + dx, cube[1] + dy, cube[2] + dz});
          if (found != first_.end() && (points[std::size_t(found->second)] - x).cwiseAbs().maxCoeff() <= edge_)
            return found->second;
        }
    first_.emplace(cube, number);
    return number;
  }

 private:
  struct Hash {
    std::size_t operator()(std::array<std::int64_t, 3> const& cube) const {
      std::uint64_t h = 0;
      for (auto const k : cube) h = (h ^ std::uint64_t(k)) * 0x9e3779b97f4a7c15U, h ^= h >> 29;
      return std::size_t(h);
    }
  };
  Vec<3, double> low_;
  double edge_;
  std::unordered_map<std::array<std::int64_t, 3>, int, Hash> first_;
};

}  // namespace detail

/// Joins vertices whose distance along each axis is at most the fraction `part` of the largest extent of the mesh, and
/// drops vertices without a triangle. Returns the number of vertices that were replaced by a different one; equal
/// vertices are not included, because STL repeats each vertex in each of its triangles.
inline long weld(Triangles& mesh, double part = detail::apart_at_least) {
  Box<3> const box = bounds_of(mesh);
  double const edge = part * std::max((box.high - box.low).maxCoeff(), 1e-300);
  std::vector<int> place(mesh.vertices.size(), -1);
  std::vector<Vec<3, double>> kept;
  detail::CubeTable table(box.low, edge, mesh.vertices.size() / 4);
  long moved = 0;
  for (auto& triangle : mesh.corners)
    for (int& corner : triangle) {
      auto const& x = mesh.vertices[std::size_t(corner)];
      int& to = place[std::size_t(corner)];
      if (to < 0) {
        to = table.find_or_add(x, int(kept.size()), kept);
        if (to == int(kept.size()))
          kept.push_back(x);
        else
          moved += x != kept[std::size_t(to)];
      }
      corner = to;
    }
  mesh.vertices = std::move(kept);
  return moved;
}

/// Removes triangles without area: those with two equal corners, or with an area of at most `part` times the square of
/// the longest side. Returns their number.
inline long drop_degenerate(Triangles& mesh, double part = 1e-12) {
  std::size_t kept = 0;
  if (mesh.numbers.empty())
    for (std::size_t t = 0; t < mesh.size(); ++t) mesh.numbers.push_back(int(t) + 1);
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, (mesh.vertex(t, k) - mesh.vertex(t, (k + 1) % 3)).squaredNorm());
    if (!(mesh.area_vector(t).norm() > part * longest)) continue;
    mesh.corners[kept] = mesh.corners[t];
    mesh.numbers[kept] = mesh.numbers[t];
    ++kept;
  }
  long const dropped = long(mesh.size() - kept);
  mesh.corners.resize(kept);
  mesh.numbers.resize(kept);
  return dropped;
}

}  // namespace scree
