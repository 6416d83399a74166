// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/types.hpp"

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace scree {

/// Triangles as a file gives them, counter-clockwise as seen from outside. Nothing about them is checked but that
/// corners are vertices and that coordinates are finite.
struct Triangles {
  std::string name = "mesh";                     // of the file
  std::vector<Vec<3, double>> vertices = {};     // m
  std::vector<std::array<int, 3>> corners = {};  // of each triangle, places in `vertices`
  std::vector<int> numbers = {};      // of each triangle in the file, from 1; of its line in a text; may be empty
  std::string numbered = "triangle";  // "triangle" or "line": which of both `numbers` are

  std::size_t size() const { return corners.size(); }
  Vec<3, double> const& vertex(std::size_t triangle, std::size_t k) const {
    return vertices[static_cast<std::size_t>(corners[triangle][k])];
  }
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

}  // namespace scree
