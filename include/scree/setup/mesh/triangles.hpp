// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/available_memory.hpp"
#include "../../core/types.hpp"

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace scree {

/// Triangles as read from a file, counter-clockwise as seen from outside. Only two conditions are checked: corners are
/// vertices, and coordinates are finite.
struct Triangles {
  std::string name = "mesh";                     ///< of the file
  std::vector<Vec<3, double>> vertices = {};     ///< m
  std::vector<std::array<int, 3>> corners = {};  ///< of each triangle, as places in `vertices`
  std::vector<int> numbers = {};      ///< of each triangle in the file, or of its line in a text, from 1; may be empty
  std::string numbered = "triangle";  ///< what `numbers` refers to: "triangle" or "line"

  /// Returns the number of triangles.
  std::size_t size() const { return corners.size(); }
  /// Returns corner k of a triangle, m.
  Vec<3, double> const& vertex(std::size_t triangle, std::size_t k) const {
    return vertices[static_cast<std::size_t>(corners[triangle][k])];
  }
  /// Returns the number of a triangle, or of its line, in the file, from 1.
  int number_of(std::size_t triangle) const { return numbers.empty() ? int(triangle) + 1 : numbers[triangle]; }
  /// Returns the place of a triangle for messages, such as "vessel.stl, triangle 17".
  std::string place_of(std::size_t triangle) const {
    return name + ", " + numbered + " " + std::to_string(number_of(triangle));
  }
  /// Returns half the cross product of two sides, which points outwards; its length is the area, m^2.
  Vec<3, double> area_vector(std::size_t triangle) const {
    Vec<3, double> const a = vertex(triangle, 0), b = vertex(triangle, 1) - a, c = vertex(triangle, 2) - a;
    return b.cross(c) / 2;
  }
};

namespace detail {
/// Throws std::runtime_error if there are more vertices than can be counted; check_triangles() also does so if there is
/// too little memory for the triangles of a file, their vertices and their tree.
inline void check_vertices(std::string const& name, double vertices) {
  if (!(vertices <= most_particles))
    throw std::runtime_error(name + ": " + short_text(vertices) + " vertices are more than can be counted");
}
inline void check_triangles(std::string const& name, double triangles) {
  check_vertices(name, 3 * triangles);
  double const needed = 700 * triangles, there = available_memory();
  if (needed > there)
    throw std::runtime_error(name + ": " + short_text(triangles) + " triangles need " + short_text(needed * 1e-9) +
                             " GB of memory, " + short_text(there * 1e-9) + " GB are there");
}
}  // namespace detail

}  // namespace scree
