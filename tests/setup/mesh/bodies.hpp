// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/kernels/kernel.hpp>
#include <scree/setup/mesh/triangles.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

// Bodies as triangles, files of them, and distances computed in another way.
namespace scree::test {

using X3 = Vec<3, double>;

/// A grid of rows x columns quadrilaterals over [0, 1]^2, each cut into two triangles; both parameters are periodic.
inline Triangles periodic_patch(int rows, int columns, std::function<X3(double, double)> const& at) {
  Triangles mesh;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) mesh.vertices.push_back(at(double(i) / rows, double(j) / columns));
  auto const place = [&](int i, int j) { return (i % rows) * columns + j % columns; };
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      mesh.corners.push_back({place(i, j), place(i + 1, j), place(i + 1, j + 1)});
      mesh.corners.push_back({place(i, j), place(i + 1, j + 1), place(i, j + 1)});
    }
  return mesh;
}

/// A torus around the z axis.
inline Triangles torus_mesh(double major, double minor, int around, int across) {
  using std::numbers::pi;
  return periodic_patch(around, across, [=](double u, double v) {
    double const a = 2 * pi * u, b = 2 * pi * v, r = major + minor * std::cos(b);
    return X3(r * std::cos(a), r * std::sin(a), minor * std::sin(b));
  });
}

/// Appends triangles; vertices are repeated.
inline void append(Triangles& to, Triangles const& mesh) {
  int const shift = int(to.vertices.size());
  to.vertices.insert(to.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
  for (auto const& [a, b, c] : mesh.corners) to.corners.push_back({a + shift, b + shift, c + shift});
}

/// A sphere around the origin: an octahedron whose sides are divided into n^2 triangles each.
inline Triangles sphere_mesh(double radius, int n) {
  Triangles mesh;
  for (int octant = 0; octant < 8; ++octant) {
    X3 const sign(octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1);
    bool const mirrored = sign.prod() < 0;
    int const first = int(mesh.vertices.size());
    auto const place = [&](int i, int j) { return first + i * (n + 1) - i * (i - 1) / 2 + j; };
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n - i; ++j)
        mesh.vertices.push_back(X3(X3(i, j, n - i - j).cwiseProduct(sign)).normalized() * radius);
    auto const add = [&](int a, int b, int c) {
      mesh.corners.push_back(mirrored ? std::array{a, c, b} : std::array{a, b, c});
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n - i; ++j) {
        add(place(i, j), place(i + 1, j), place(i, j + 1));
        if (j + 1 < n - i) add(place(i + 1, j), place(i + 1, j + 1), place(i, j + 1));
      }
  }
  return mesh;
}

/// A box between two corners, of 12 triangles.
inline Triangles box_mesh(X3 const& low, X3 const& high) {
  Triangles mesh;
  for (int k = 0; k < 8; ++k)
    mesh.vertices.push_back({k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1], k & 4 ? high[2] : low[2]});
  mesh.corners = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                  {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

inline Triangles without(Triangles mesh, std::function<bool(std::size_t)> const& drop) {
  auto const all = mesh.corners;
  mesh.corners.clear();
  for (std::size_t t = 0; t < all.size(); ++t)
    if (!drop(t)) mesh.corners.push_back(all[t]);
  return mesh;
}
/// A mesh without a share of its triangles, chosen at random.
inline Triangles with_holes(Triangles const& mesh, double share) {
  std::mt19937 random(7);
  return without(mesh, [&](std::size_t) { return double(random()) < share * double(random.max()); });
}
inline void turn_over(Triangles& mesh, std::size_t t) { std::swap(mesh.corners[t][1], mesh.corners[t][2]); }

inline std::string ascii_stl(Triangles const& mesh) {
  std::string text = "solid a body\n";
  char line[120];
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    text += "  facet normal 0 0 0\n    outer loop\n";
    for (std::size_t k = 0; k < 3; ++k) {
      X3 const& x = mesh.vertex(t, k);
      std::snprintf(line, sizeof line, "      vertex %.17g %.17g %.17g\n", x[0], x[1], x[2]);
      text += line;
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid a body\n";
}

inline void put(std::string& bytes, std::uint32_t bits) {
  for (unsigned k = 0; k < 4; ++k) bytes += char((bits >> (8 * k)) & 255);
}
inline std::string binary_stl(Triangles const& mesh, std::string head = "made by a test") {
  head.resize(80, ' ');
  put(head, std::uint32_t(mesh.size()));
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    for (int k = 0; k < 3; ++k) put(head, 0);
    for (std::size_t k = 0; k < 3; ++k)
      for (int axis = 0; axis < 3; ++axis) put(head, std::bit_cast<std::uint32_t>(float(mesh.vertex(t, k)[axis])));
    head += std::string(2, '\0');
  }
  return head;
}

/// Distance from a triangle, by its plane or by its three sides, in long double.
inline double distance_from_triangle(Triangles const& mesh, std::size_t t, X3 const& x) {
  using L = Eigen::Matrix<long double, 3, 1>;
  L const p = x.cast<long double>();
  L v[3];
  for (std::size_t k = 0; k < 3; ++k) v[k] = mesh.vertex(t, k).cast<long double>();
  L const n = (v[1] - v[0]).cross(v[2] - v[0]).normalized();
  bool above = true;
  long double least = std::numeric_limits<long double>::infinity();
  for (int k = 0; k < 3; ++k) {
    L const side = v[(k + 1) % 3] - v[k], to = p - v[k];
    above = above && n.cross(side).dot(to) >= 0;
    long double const along = std::clamp(to.dot(side) / side.squaredNorm(), 0.0L, 1.0L);
    least = std::min(least, (to - along * side).norm());
  }
  return double(above ? std::abs(n.dot(p - v[0])) : least);
}
inline double distance_from_all(Triangles const& mesh, X3 const& x) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.size(); ++t) least = std::min(least, distance_from_triangle(mesh, t, x));
  return least;
}

/// Points around a body with coordinates up to `reach`.
inline std::vector<X3> random_points(int count, double reach) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> there(-reach, reach);
  std::vector<X3> points;
  for (int k = 0; k < count; ++k) points.push_back(X3(there(random), there(random), there(random)));
  return points;
}

}  // namespace scree::test
