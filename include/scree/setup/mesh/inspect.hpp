// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "report.hpp"
#include "tree.hpp"
#include "winding.hpp"

#include <cmath>

// Checks of a mesh that need its tree.
namespace scree::detail {

/// Adds which triangles bound the inside, from the winding number just behind the middle of each: 1 at a triangle that
/// does, 2 or more within another shell, near 0 where nothing is enclosed.
inline void check_inside(MeshReport& report, Triangles const& mesh, TriangleTree const& tree,
                         WindingNumbers const& winding) {
  double buried = 0, unbounded = 0;
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    Vec<3, double> const area = mesh.area_vector(t);
    double const size = area.norm();
    Vec<3, double> const behind =
        (mesh.vertex(t, 0) + mesh.vertex(t, 1) + mesh.vertex(t, 2)) / 3 - area * (1e-3 / std::sqrt(size));
    double const w = winding(tree, behind, report.closed);
    if (w > 1.5) {
      if (report.first_buried.empty()) report.first_buried = mesh.place_of(t);
      buried += size;
    } else if (!(w > 0.5)) {
      if (report.first_unbounded.empty()) report.first_unbounded = mesh.place_of(t);
      unbounded += size;
    }
  }
  report.buried_share = buried / report.area;
  report.unbounded_share = unbounded / report.area;
}

/// The smallest distance along the normals, or against them, between triangles that face each other.
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
