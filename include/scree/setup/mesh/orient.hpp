// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "edges.hpp"
#include "triangle.hpp"
#include "weld.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace scree {
namespace detail {

/// Triangles joined across edges of two triangles.
struct Shell {
  std::vector<int> triangles;
  bool closed = true;  // each edge belongs to two triangles
  double volume = 0;   // m^3, by the orientation of its triangles
  long turned = 0;     // triangles that were turned over so that all agree
  Box<3> bounds;
};

inline void turn_over(Triangles& mesh, int triangle) {
  auto& corners = mesh.corners[std::size_t(triangle)];
  std::swap(corners[1], corners[2]);
}

inline Corners corners_of(Triangles const& mesh, std::size_t t) {
  return {mesh.vertex(t, 0), mesh.vertex(t, 1), mesh.vertex(t, 2)};
}

/// Volume between the triangles of a closed surface and any point, m^3.
inline double volume_between(Triangles const& mesh, std::vector<int> const& triangles, Vec<3, double> const& point) {
  double volume = 0;
  for (int const t : triangles)
    volume += (mesh.vertex(std::size_t(t), 0) - point).dot(mesh.area_vector(std::size_t(t))) / 3;
  return volume;
}

/// Collects shells and turns triangles over until those of each shell agree with most of them.
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

/// Whether a closed shell, of any orientation, contains x.
inline bool within(Triangles const& mesh, Shell const& shell, Vec<3, double> const& x) {
  if (!shell.closed || !shell.bounds.contains(x)) return false;
  double winding = 0;
  for (int const t : shell.triangles) winding += solid_angle_share(corners_of(mesh, std::size_t(t)), x);
  return std::abs(winding) > 0.5;
}

/// Whether any other of the shells contains this one, tried at a vertex.
inline bool is_nested(Triangles const& mesh, std::vector<Shell> const& shells, std::size_t which) {
  Vec<3, double> const x = mesh.vertex(std::size_t(shells[which].triangles[0]), 0);
  for (std::size_t k = 0; k < shells.size(); ++k)
    if (k != which && within(mesh, shells[k], x)) return true;
  return false;
}

}  // namespace detail

/// The shells and edges of a mesh, and the changes of the orientation of its triangles.
struct Orientation {
  long shells = 0, closed_shells = 0, nested_shells = 0;
  long turned_triangles = 0;  // turned over to agree with most of their shell
  long turned_shells = 0;     // closed, as a whole, because they were inside out
  std::vector<int> open_edges = {},
                   crowded_edges = {};  // a triangle at each edge of one triangle, and of more than two
};

/// Makes the triangles of each shell agree, where most of them decide, and turns over closed shells that are inside out
/// unless another one contains them: those may be cavities. Throws std::runtime_error with the file and the triangle
/// for a surface with only one side.
inline Orientation orient(Triangles& mesh) {
  detail::Edges const edges(mesh);
  auto const shells = detail::ShellFinder(mesh, edges)();
  Orientation result{.open_edges = edges.open, .crowded_edges = edges.crowded};
  for (std::size_t k = 0; k < shells.size(); ++k) {
    auto const& shell = shells[k];
    ++result.shells;
    result.closed_shells += shell.closed;
    result.turned_triangles += shell.turned;
    bool const inside_out = shell.closed && shell.volume < 0;
    if (!inside_out) continue;
    if (detail::is_nested(mesh, shells, k)) {
      ++result.nested_shells;
      continue;
    }
    ++result.turned_shells;
    for (int const t : shell.triangles) detail::turn_over(mesh, t);
  }
  return result;
}

}  // namespace scree
