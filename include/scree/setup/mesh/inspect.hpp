// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/in_layers.hpp"
#include "report.hpp"
#include "tree.hpp"
#include "unite.hpp"
#include "winding.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

// Checks of a mesh that need its tree.
namespace scree::detail {

/// Returns the winding number of a closed surface just behind a triangle, and the point at which it was computed:
/// behind the middle of the triangle or, if that point is on the surface itself, behind another point of the triangle.
/// Returns no value if all these points are on the surface.
inline std::optional<std::pair<double, Vec<3, double>>> number_behind(Corners const& abc, TriangleTree const& tree,
                                                                      WindingNumbers const& winding,
                                                                      Vec<3, double> const& depth) {
  constexpr double weights[][3] = {{1, 1, 1}, {5, 3, 2}, {2, 5, 3}, {3, 2, 5}};  // of the corners
  for (auto const& [a, b, c] : weights) {
    Vec<3, double> const x = (a * abc[0] + b * abc[1] + c * abc[2]) / (a + b + c) - depth;
    if (auto const number = winding.off_surface(tree, x)) return std::pair(*number, x);
  }
  return std::nullopt;
}

/// Returns the winding number just behind the middle of each triangle, or close to it (see number_behind()). In a
/// closed mesh, the numbers of triangles that are next to each other in the tree differ by the net number of crossings
/// of the surface between them.
inline std::vector<double> numbers_behind(Triangles const& mesh, TriangleTree const& tree,
                                          WindingNumbers const& winding, bool closed) {
  constexpr std::size_t portion = 1024;
  std::vector<double> numbers(mesh.size());
  double const margin = apart_at_least * tree.extent(), depth = probe_depth * tree.extent();
  for_each_layer(long((mesh.size() + portion - 1) / portion), [&](long layer) {
    std::size_t const first = std::size_t(layer) * portion, last = std::min(first + portion, mesh.size());
    Vec<3, double> before = Vec<3, double>::Zero();
    double w = 0;
    for (std::size_t k = first; k < last; ++k) {
      auto const t = std::size_t(tree.place(int(k)));
      Corners const abc{mesh.vertex(t, 0), mesh.vertex(t, 1), mesh.vertex(t, 2)};
      Vec<3, double> const away = mesh.area_vector(t).normalized() * depth;
      Vec<3, double> const middle = (abc[0] + abc[1] + abc[2]) / 3 - away;
      auto const entries = closed && k > first ? tree.entries(before, middle, margin) : std::nullopt;
      auto const beside = closed && !entries ? number_behind(abc, tree, winding, away) : std::nullopt;
      w = entries ? w + *entries : beside ? beside->first : winding(tree, middle, closed);
      before = beside ? beside->second : middle;
      numbers[t] = w;
    }
  });
  return numbers;
}

/// Adds to a report which shares of the area do not bound the inside. The winding number just behind the middle of a
/// triangle is 1 if the triangle bounds the inside, 2 or more if it is within another shell, and near 0 if nothing is
/// enclosed.
inline void check_inside(MeshReport& report, Triangles const& mesh, std::vector<double> const& behind) {
  double buried = 0, unbounded = 0;
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    double const size = mesh.area_vector(t).norm();
    if (behind[t] > 1.5) {
      if (report.first_buried.empty()) report.first_buried = mesh.place_of(t);
      buried += size;
    } else if (!(behind[t] > 0.5)) {
      if (report.first_unbounded.empty()) report.first_unbounded = mesh.place_of(t);
      unbounded += size;
    }
  }
  report.buried_share = buried / report.area;
  report.unbounded_share = unbounded / report.area;
}

/// Returns the smallest distance between triangles that face each other, along the normals (`side` 1) or against them
/// (-1).
inline FacingDistance least_facing(Triangles const& mesh, TriangleTree const& tree, double side) {
  FacingDistance found;
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    Vec<3, double> const normal = mesh.area_vector(t).normalized();
    Vec<3, double> const middle = (mesh.vertex(t, 0) + mesh.vertex(t, 1) + mesh.vertex(t, 2)) / 3;
    auto const faces = [&](int other) {
      return mesh.area_vector(std::size_t(other)).normalized().dot(normal) < -0.5 && other != int(t);
    };
    double const distance = tree.first_along(middle, side * normal, 0, found.distance, faces).distance;
    if (distance < found.distance) found = {distance, mesh.place_of(t)};
  }
  return found;
}

}  // namespace scree::detail
