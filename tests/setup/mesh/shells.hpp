// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "bodies.hpp"

#include <optional>
#include <utility>

// Random sets of closed shells whose union is known from their planes.
namespace scree::test::shells {

/// A box turned in space or a tetrahedron, as planes: inside is where all of them are in front.
struct Convex {
  std::vector<X3> points, normals;  // of the planes; normals of length one, inwards
  Triangles triangles;
  bool hollow = false;

  /// Positive inside; the distance from the nearest plane.
  double depth(X3 const& x) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < points.size(); ++k) least = std::min(least, normals[k].dot(X3(x - points[k])));
    return least;
  }
};

struct Random {
  std::mt19937 engine;
  int whole(int low, int high) { return low + int(engine() % unsigned(high - low + 1)); }
  double part() { return double(engine()) / 4294967296.0; }
  /// The coordinates are made one after another, so that all compilers get the same points.
  X3 point() {
    X3 x;
    for (int axis = 0; axis < 3; ++axis) x[axis] = 2 * part() - 1;
    return x;
  }
  X3 grid_point() {
    X3 x;
    for (int axis = 0; axis < 3; ++axis) x[axis] = whole(0, 4) * 0.5 - 1;
    return x;
  }
};

inline Convex convex_box(Random& random, X3 const& low, X3 const& high, Mat<3, double> const& turn) {
  Convex box;
  box.triangles = box_mesh(low, high);
  for (std::size_t face = 0; face < 6; ++face) {  // along one diagonal or the other
    auto &one = box.triangles.corners[2 * face], &other = box.triangles.corners[2 * face + 1];
    std::array<int, 4> const round{one[0], one[1], one[2], other[2]};
    if (random.whole(0, 1) == 0) one = {round[0], round[1], round[3]}, other = {round[1], round[2], round[3]};
  }
  for (auto& x : box.triangles.vertices) x = X3(turn * x);
  for (int axis = 0; axis < 3; ++axis)
    for (double const side : {1.0, -1.0}) {
      box.points.push_back(turn * (side > 0 ? low : high));
      box.normals.push_back(side * turn * X3::Unit(axis));
    }
  return box;
}
inline Convex tetrahedron(std::array<X3, 4> corners) {
  Convex result;
  if (X3(corners[1] - corners[0]).cross(X3(corners[2] - corners[0])).dot(X3(corners[3] - corners[0])) < 0)
    std::swap(corners[0], corners[1]);
  result.triangles.vertices.assign(corners.begin(), corners.end());
  result.triangles.corners = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  for (std::size_t t = 0; t < 4; ++t) {
    result.points.push_back(result.triangles.vertex(t, 0));
    result.normals.push_back(-result.triangles.area_vector(t).normalized());
  }
  return result;
}

/// 1 to 5 shells. Corners of boxes and of half of the tetrahedra are on a coarse grid, so that faces, edges and corners
/// coincide; each fourth union is turned as a whole, each fourth has boxes in any direction, boxes may have a cavity.
inline std::vector<Convex> random_shells(Random& random) {
  int const kind = random.whole(0, 3), count = random.whole(1, 5);
  auto const turn = [&] {
    double const angle = 3 * random.part();  // first with every compiler: the order of arguments is not given
    return rotation_about(random.point(), angle);
  };
  Mat<3, double> const whole_turn = kind == 1 ? turn() : Mat<3, double>::Identity();
  std::vector<Convex> shells;
  while (int(shells.size()) < count) {
    if (kind >= 2 && random.whole(0, 1) == 0) {
      bool const on_grid = random.whole(0, 1) == 0;
      std::array<X3, 4> corners;
      for (auto& x : corners) x = on_grid ? random.grid_point() : random.point();
      double const six_volumes =
          X3(corners[1] - corners[0]).cross(X3(corners[2] - corners[0])).dot(X3(corners[3] - corners[0]));
      if (std::abs(six_volumes) > 0.1) shells.push_back(tetrahedron(corners));
      continue;
    }
    X3 const a = random.grid_point(), b = random.grid_point(), low = a.cwiseMin(b), high = a.cwiseMax(b);
    if ((high - low).minCoeff() == 0) continue;
    Mat<3, double> const turned = kind == 3 ? turn() : whole_turn;
    shells.push_back(convex_box(random, low, high, turned));
    if (random.whole(0, 3) > 0 || int(shells.size()) == count) continue;
    X3 const by = 0.25 * (high - low);
    shells.push_back(convex_box(random, low + by, high - by, turned));
    shells.back().hollow = true;
    for (std::size_t t = 0; t < 12; ++t) turn_over(shells.back().triangles, t);
  }
  return shells;
}

inline std::string obj(Triangles const& mesh) {
  std::string text;
  char line[120];
  for (X3 const& x : mesh.vertices) {
    std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", x[0], x[1], x[2]);
    text += line;
  }
  for (auto const& [a, b, c] : mesh.corners)
    text += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " + std::to_string(c + 1) + "\n";
  return text;
}

inline Triangles joined(std::vector<Convex> const& shells) {
  Triangles all;
  for (auto const& shell : shells) append(all, shell.triangles);
  return all;
}

/// The sum of the shells at x is positive; none where x is within 1e-6 of a plane.
inline std::optional<bool> is_within(std::vector<Convex> const& shells, X3 const& x) {
  int sum = 0;
  for (auto const& shell : shells) {
    double const depth = shell.depth(x);
    if (std::abs(depth) < 1e-6) return std::nullopt;
    if (depth > 0) sum += shell.hollow ? -1 : 1;
  }
  return sum > 0;
}

}  // namespace scree::test::shells
