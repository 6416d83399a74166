// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "edges.hpp"
#include "triangle.hpp"
#include "weld.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace scree {
namespace detail {

/// A shell: triangles that are connected across edges.
struct Shell {
  std::vector<int> triangles;
  bool closed = true;  // each edge belongs to two triangles
  double volume = 0;   // m^3, with the sign of the orientation of its triangles
  long turned = 0;     // triangles turned over to make all orientations agree
  Box<3> bounds;
};

inline void turn_over(Triangles& mesh, int triangle) {
  auto& corners = mesh.corners[std::size_t(triangle)];
  std::swap(corners[1], corners[2]);
}

inline Corners corners_of(Triangles const& mesh, std::size_t t) {
  return {mesh.vertex(t, 0), mesh.vertex(t, 1), mesh.vertex(t, 2)};
}

/// Returns the volume between triangles and a point, m^3; for a closed surface, it does not depend on the point.
inline double volume_between(Triangles const& mesh, std::vector<int> const& triangles, Vec<3, double> const& point) {
  double volume = 0;
  for (int const t : triangles)
    volume += (mesh.vertex(std::size_t(t), 0) - point).dot(mesh.area_vector(std::size_t(t))) / 3;
  return volume;
}

/// Collects the shells of a mesh, and turns over triangles that do not agree with most triangles of their shell.
class ShellFinder {
 public:
  ShellFinder(Triangles& mesh, Edges const& edges)
      : mesh_(mesh), edges_(edges), seen_(mesh.size(), false), turned_(mesh.size(), false) {}

  std::vector<Shell> operator()() {
    std::vector<Shell> shells;
    for (std::size_t t = 0; t < mesh_.size(); ++t)
      if (!seen_[t]) shells.push_back(shell_of(int(t)));
    return shells;
  }

 private:
  Shell shell_of(int first) {
    Shell shell;
    shell.triangles.push_back(first);
    seen_[std::size_t(first)] = true;
    for (std::size_t k = 0; k < shell.triangles.size(); ++k) visit(shell.triangles[k], shell);
    long const count = long(shell.triangles.size());
    for (int const t : shell.triangles) shell.turned += turned_[std::size_t(t)];
    bool const most = 2 * shell.turned > count;
    if (most) shell.turned = count - shell.turned;
    Vec<3, double> const x = mesh_.vertex(std::size_t(first), 0);
    shell.bounds = {x, x};
    for (int const t : shell.triangles) {
      if (turned_[std::size_t(t)] != most) turn_over(mesh_, t);
      for (std::size_t k = 0; k < 3; ++k)
        shell.bounds = hull(shell.bounds, Box<3>{mesh_.vertex(std::size_t(t), k), mesh_.vertex(std::size_t(t), k)});
    }
    shell.volume = volume_between(mesh_, shell.triangles, (shell.bounds.low + shell.bounds.high) / 2);
    return shell;
  }
  void visit(int triangle, Shell& shell) {
    for (auto const& [other, same_direction] : edges_.across[std::size_t(triangle)]) {
      if (other == Edges::none) {
        shell.closed = false;
        continue;
      }
      auto const k = std::size_t(other);
      bool const turned = turned_[std::size_t(triangle)] != same_direction;
      if (!seen_[k]) {
        seen_[k] = true, turned_[k] = turned;
        shell.triangles.push_back(other);
      } else if (turned_[k] != turned) {
        throw std::runtime_error(mesh_.place_of(k) + ": this surface has only one side, like a Moebius strip");
      }
    }
  }

  Triangles& mesh_;
  Edges const& edges_;
  std::vector<bool> seen_, turned_;
};

/// The position of a closed shell that is inside out, relative to larger shells.
enum class Nesting { apart, touching, within };

/// Returns the winding number of closed shells at x.
inline double winding_of(Triangles const& mesh, std::vector<Shell const*> const& shells, Vec<3, double> const& x) {
  double winding = 0;
  for (Shell const* shell : shells)
    if (shell->bounds.contains(x))
      for (int const t : shell->triangles) winding += solid_angle_share(corners_of(mesh, std::size_t(t)), x);
  return winding;
}

/// Returns the position of a shell relative to larger ones. Points on both sides of up to 256 triangles of the shell
/// are checked, at the distance `depth` (m) from the middle and from places near the corners; fewer triangles if the
/// larger shells have many.
inline Nesting nesting_of(Triangles const& mesh, Shell const& shell, std::vector<Shell const*> const& larger,
                          double depth) {
  double others = 0;
  for (Shell const* other : larger) others += double(other->triangles.size());
  std::size_t const samples = std::size_t(std::clamp(1e6 / std::max(others, 1.0), 4.0, 256.0));
  std::size_t const stride = std::max<std::size_t>(shell.triangles.size() / samples, 1);
  Nesting found = Nesting::within;
  for (std::size_t k = 0; k < shell.triangles.size(); k += stride) {
    auto const t = std::size_t(shell.triangles[k]);
    Corners const abc = corners_of(mesh, t);
    Vec<3, double> const away = mesh.area_vector(t).normalized() * depth, middle = (abc[0] + abc[1] + abc[2]) / 3;
    for (auto const& x : {middle, abc[0], abc[1], abc[2]}) {
      Vec<3, double> const near = middle + 0.999 * (x - middle);
      if (winding_of(mesh, larger, near + away) < 0.5) return Nesting::apart;
      if (winding_of(mesh, larger, near - away) < 0.5) found = Nesting::touching;
    }
  }
  return found;
}

}  // namespace detail

/// The shells and edges of a mesh, and the changes that were made to the orientation of its triangles.
struct Orientation {
  long shells = 0, closed_shells = 0, nested_shells = 0;
  long turned_triangles = 0;  ///< turned over to agree with most of their shell
  long turned_shells = 0;     ///< closed shells turned over because they were inside out
  std::vector<int> open_edges = {},
                   crowded_edges = {};  ///< a triangle at each edge that has only one, or more than two
};

/// Turns over triangles that do not agree with most triangles of their shell, and closed shells that are inside out,
/// except those within the material of larger shells, which are cavities. Returns these changes. Throws
/// std::runtime_error, with the file and the triangle, for a surface with only one side, and for a shell that may or
/// may not be a cavity, because it is inside out and touches the surface of larger shells from within.
inline Orientation orient(Triangles& mesh) {
  detail::Edges const edges(mesh);
  auto const shells = detail::ShellFinder(mesh, edges)();
  Orientation result{.open_edges = edges.open, .crowded_edges = edges.crowded};
  std::vector<detail::Shell const*> closed, larger;
  for (auto const& shell : shells) {
    ++result.shells;
    result.turned_triangles += shell.turned;
    if (shell.closed) closed.push_back(&shell);
  }
  result.closed_shells = long(closed.size());
  std::stable_sort(closed.begin(), closed.end(), [](detail::Shell const* one, detail::Shell const* other) {
    return std::abs(one->volume) > std::abs(other->volume);
  });
  Box<3> const box = bounds_of(mesh);
  double const depth = detail::probe_depth * (box.high - box.low).maxCoeff();
  for (detail::Shell const* shell : closed) {
    if (shell->volume < 0) {
      auto const nesting = detail::nesting_of(mesh, *shell, larger, depth);
      if (nesting == detail::Nesting::touching)
        throw std::runtime_error(mesh.place_of(std::size_t(shell->triangles[0])) +
                                 ": this closed shell is inside out and touches a larger one from within: turn it over "
                                 "if it is a body, join both to one shell if it is a hollow");
      if (nesting == detail::Nesting::within) {
        ++result.nested_shells;
      } else {
        ++result.turned_shells;
        for (int const t : shell->triangles) detail::turn_over(mesh, t);
      }
    }
    larger.push_back(shell);
  }
  return result;
}

}  // namespace scree
