// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/setting.hpp"
#include "../shapes/shape.hpp"
#include "orient.hpp"

#include <limits>
#include <string>

namespace scree {

/// A distance between two parts of a surface that face each other, measured along the normal from the middle of a
/// triangle to the nearest triangle whose normal is within 60 degrees of the opposite direction.
struct FacingDistance {
  double distance = std::numeric_limits<double>::infinity();  ///< m
  std::string place = {};                                     ///< file and triangle; empty if no parts face each other
};

/// The contents of a mesh, and the changes that were made to it.
struct MeshReport {
  std::string name;
  long triangles_read = 0, triangles = 0;               ///< numbers in the file and in use; the union may have others
  long welded_vertices = 0;                             ///< joined with another vertex at a slightly different place
  long degenerate_triangles = 0;                        ///< dropped
  Orientation orientation = {};                         ///< shells, open edges, turned triangles
  bool closed = false;                                  ///< no border remains
  Box<3> bounds{};                                      ///< m
  double area = 0, volume = 0;                          ///< of the union: m^2, and m^3 by the divergence theorem
  double buried_share = 0;                              ///< part of the area read: within another shell or between two
  double unbounded_share = 0;                           ///< part of the area with no inside behind it: holes are near
  std::string first_buried = {}, first_unbounded = {};  ///< file and triangle
  FacingDistance wall = {}, gap = {};                   ///< wall: through the inside; gap: through the outside

  /// Whether the triangles enclose their volume without a hole; `volume` is exact only if they do.
  bool encloses_exactly() const { return closed && unbounded_share == 0; }
  /// Returns the report as lines of text, with distances in units of the spacing of particles (m).
  std::string text(double spacing) const {
    using detail::formatted;
    auto const size = Vec<3, double>(bounds.high - bounds.low);
    std::string all = formatted("%s: %ld triangles in %ld shells, %ld of them closed\n", name.c_str(), triangles,
                                orientation.shells, orientation.closed_shells);
    all += formatted("  from (%g, %g, %g) to (%g, %g, %g) m, %.4g x %.4g x %.4g spacings\n", bounds.low[0],
                     bounds.low[1], bounds.low[2], bounds.high[0], bounds.high[1], bounds.high[2], size[0] / spacing,
                     size[1] / spacing, size[2] / spacing);
    all += formatted("  area %.6g m^2, volume %.6g m^3%s\n", area, volume, encloses_exactly() ? "" : " (not exact)");
    all += facing("thinnest wall", wall, spacing) + facing("thinnest gap", gap, spacing);
    if (wall.distance < 5 * spacing)
      all += "  below 5 spacings, material on one side of a wall acts on that on the other one\n";
    all += count(orientation.open_edges.size(), "open edges: there are holes");
    all += count(orientation.crowded_edges.size(), "edges of more than two triangles");
    all += count(std::size_t(orientation.nested_shells), "closed shells within another one and inside out: cavities");
    all += share(buried_share,
                 closed ? "within another shell or between two that touch, and left out" : "within another shell",
                 first_buried);
    all += share(unbounded_share, "with no inside behind it", first_unbounded);
    all += count(std::size_t(welded_vertices), "vertices were joined with one close by");
    all += count(std::size_t(degenerate_triangles), "triangles without area were dropped");
    all +=
        count(std::size_t(orientation.turned_triangles), "triangles were turned over to agree with their neighbours");
    all += count(std::size_t(orientation.turned_shells), "closed shells were inside out and were turned over");
    return all;
  }

 private:
  static std::string facing(char const* what, FacingDistance const& found, double spacing) {
    if (found.place.empty()) return "";
    return detail::formatted("  %s: %.4g spacings, at %s\n", what, found.distance / spacing, found.place.c_str());
  }
  static std::string count(std::size_t number, char const* what) {
    return number == 0 ? "" : detail::formatted("  %zu %s\n", number, what);
  }
  static std::string share(double part, char const* what, std::string const& first) {
    return part == 0 ? ""
                     : detail::formatted("  %.3g %% of the area %s; first at %s\n", 100 * part, what, first.c_str());
  }
};

}  // namespace scree
