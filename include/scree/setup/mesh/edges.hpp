// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/room.hpp"
#include "triangles.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

namespace scree::detail {

/// An edge of a triangle, from its corner `corner` to the next one.
struct Side {
  int low, high;  // vertices, ordered
  int triangle, corner;
  bool forwards;  // from `low` to `high`
};

/// The sides of all triangles, those of one edge next to each other.
inline std::vector<Side> sides_of(Triangles const& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.size());
  for (std::size_t t = 0; t < mesh.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      int const a = mesh.corners[t][k], b = mesh.corners[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), int(t), int(k), a < b});
    }
  std::sort(sides.begin(), sides.end(), [](Side const& a, Side const& b) {
    return std::tie(a.low, a.high, a.triangle, a.corner) < std::tie(b.low, b.high, b.triangle, b.corner);
  });
  return sides;
}

/// How triangles are joined: across edges of exactly two triangles.
struct Edges {
  static constexpr int none = -1;
  struct Across {
    int triangle = none;
    bool same_direction = false;  // both triangles run along the edge in the same direction: one of them is turned over
  };
  std::vector<std::array<Across, 3>> across;  // each side of each triangle
  std::vector<int> open, crowded;             // a triangle at each edge of one triangle, and of more than two

  explicit Edges(Triangles const& mesh) : across(mesh.size()) {
    auto const sides = sides_of(mesh);
    for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
      while (last < sides.size() && sides[last].low == sides[first].low && sides[last].high == sides[first].high)
        ++last;
      Side const &a = sides[first], &b = sides[last - 1];
      if (last - first == 1) open.push_back(a.triangle);
      if (last - first > 2) crowded.push_back(a.triangle);
      if (last - first != 2) continue;
      join(a, b);
      join(b, a);
    }
  }

 private:
  void join(Side const& from, Side const& to) {
    across[std::size_t(from.triangle)][std::size_t(from.corner)] = {to.triangle, from.forwards == to.forwards};
  }
};

/// Whether the triangles have no border: along each edge they run in both directions equally often.
inline bool is_closed(Triangles const& mesh) {
  auto const sides = sides_of(mesh);
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    int sum = 0;
    for (; last < sides.size() && sides[last].low == sides[first].low && sides[last].high == sides[first].high; ++last)
      sum += sides[last].forwards ? 1 : -1;
    if (sum != 0) return false;
  }
  return true;
}

}  // namespace scree::detail
