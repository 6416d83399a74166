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

/// Triangles as a file gives them, counter-clockwise as seen from outside. It is only checked that corners are vertices
/// and that coordinates are finite.
struct Triangles {
  std::string name = "mesh";                     ///< of the file
  std::vector<Vec<3, double>> vertices = {};     ///< m
  std::vector<std::array<int, 3>> corners = {};  ///< of each triangle, places in `vertices`
  std::vector<int> numbers = {};      ///< of each triangle in the file, from 1; of its line in a text; may be empty
  std::string numbered = "triangle";  ///< "triangle" or "line": which of both `numbers` are

  /// The number of triangles.
  std::size_t size() const { return corners.size(); }
  /// Corner k of a triangle, m.
  Vec<3, double> const& vertex(std::size_t triangle, std::size_t k) const {
    return vertices[static_cast<std::size_t>(corners[triangle][k])];
  }
  /// The number of a triangle in its file, from 1.
  int number_of(std::size_t triangle) const { return numbers.empty() ? int(triangle) + 1 : numbers[triangle]; }
  /// "vessel.stl, triangle 17", for messages.
  std::string place_of(std::size_t triangle) const {
    return name + ", " + numbered + " " + std::to_string(number_of(triangle));
  }
  /// Half the cross product of two sides: its length is the area, m^2, and it points outwards.
  Vec<3, double> area_vector(std::size_t triangle) const {
    Vec<3, double> const a = vertex(triangle, 0), b = vertex(triangle, 1) - a, c = vertex(triangle, 2) - a;
    return b.cross(c) / 2;
  }
};

namespace detail {
/// Throws std::runtime_error if there are more vertices than can be counted, or too little memory for the triangles of
/// a file, their vertices and their hierarchy.
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
