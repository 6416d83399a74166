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

/// Twice the area of the triangle a, b, c; positive if it is counter-clockwise.
double turn(Vec<2, double> const& a, Vec<2, double> const& b, Vec<2, double> const& c);

/// A side of a polygon.
struct Segment {
  Vec<2, double> a, b;

  Vec<2, double> nearest(Vec<2, double> const& x) const;
  /// Whether a ray from x along the first axis crosses the side, whose lower end belongs to it.
  bool is_right_of(Vec<2, double> const& x) const;
  bool crosses(Segment const& other) const;
  /// Integral of min(y, level) over x along the edge, m^2.
  double below(double level) const;
};

}  // namespace detail

/// A closed polygon in the plane, or several that do not cross: inside is where a ray crosses an odd number of sides,
/// so that a polygon within another one is a hole. Counter-clockwise or clockwise. Copies share their data; host only.
class Polygon {
 public:
  static constexpr int dim = 2;
  static constexpr char const* name = "Polygon";
  static constexpr bool costly_distance = true;
  using Loop = std::vector<Vec<2, double>>;

  /// A region whose outline is made of polygons, each given by its corners, m. Throws std::invalid_argument if a
  /// polygon has less than three corners or no area, a corner is not finite, or sides cross; the time to find this goes
  /// with the square of the number of sides, of which 20 000 are allowed.
  explicit Polygon(std::vector<Loop> const& loops);
  explicit Polygon(Loop const& loop) : Polygon(std::vector<Loop>{loop}) {}

  /// Exact, m.
  double signed_distance(Vec<2, double> const& x) const;
  bool contains(Vec<2, double> const& x) const;
  Box<2> bounds() const { return data_->bounds; }
  /// The point of the sides that is nearest to x, m.
  Vec<2, double> nearest(Vec<2, double> const& x) const;
  /// The area below a level of the last coordinate (m), m^2.
  std::optional<double> exact_volume_below(double level) const;

 private:
  struct Data {
    std::vector<detail::Segment> sides;
    std::vector<double> orientation;  // of each loop: 1 if its direction agrees with the inside on its left, or -1
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
