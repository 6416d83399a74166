// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/setting.hpp"
#include "shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace scree {
namespace detail {

/// Returns twice the area of the triangle a, b, c; positive if its corners are counter-clockwise.
double turn(Vec<2, double> const& a, Vec<2, double> const& b, Vec<2, double> const& c);

/// A side of a polygon.
struct Segment {
  Vec<2, double> a, b;

  Vec<2, double> nearest(Vec<2, double> const& x) const;
  /// Whether a ray from x along the first axis crosses the side. The lower end belongs to the side, the upper one does
  /// not.
  bool is_right_of(Vec<2, double> const& x) const;
  bool crosses(Segment const& other) const;
  /// Returns the integral of min(y, level) over x along the side, m^2.
  double below(double level) const;
};

}  // namespace detail

/// One closed polygon in the plane, or several that do not cross. A point is inside if a ray from it crosses an odd
/// number of sides, so that a polygon within another one is a hole. Corners may be counter-clockwise or clockwise.
/// Copies share their data; host only.
class Polygon {
 public:
  static constexpr int dim = 2;
  static constexpr char const* name = "Polygon";
  static constexpr bool costly_distance = true;
  using Loop = std::vector<Vec<2, double>>;

  /// Makes a region whose outline consists of polygons, each given by its corners, m. Throws std::invalid_argument if a
  /// polygon has fewer than three corners or no area, a corner is repeated or not finite, sides cross, or there are
  /// more than 20 000 sides. The check for crossings takes a time proportional to the square of the number of sides.
  explicit Polygon(std::vector<Loop> const& loops);
  explicit Polygon(Loop const& loop) : Polygon(std::vector<Loop>{loop}) {}

  /// Returns the exact signed distance of x, m.
  double signed_distance(Vec<2, double> const& x) const;
  bool contains(Vec<2, double> const& x) const;
  Box<2> bounds() const { return data_->bounds; }
  /// Returns the point of the sides that is nearest to x, m.
  Vec<2, double> nearest(Vec<2, double> const& x) const;
  /// Returns the area (m^2) below a level (m) of the last coordinate.
  std::optional<double> exact_volume_below(double level) const;

 private:
  struct Data {
    std::vector<detail::Segment> sides;
    std::vector<double> orientation;  // of each loop: 1 if the inside is on its left, otherwise -1
    std::vector<std::size_t> sizes;
    Box<2> bounds;
  };

  [[noreturn]] static void fail(std::string const& why);
  static void add(std::vector<detail::Segment>& sides, Loop const& loop);
  static void check_crossings(std::vector<detail::Segment> const& sides);
  static double orientation_of(std::vector<detail::Segment> const& sides, Loop const& loop);

  std::shared_ptr<Data const> data_;
};

}  // namespace scree

#ifndef SCREE_COMPILED
#include "polygon.ipp"
#endif
