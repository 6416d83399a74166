// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/compiled.hpp"
#include "polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace scree {
namespace detail {

SCREE_BODY double turn(Vec<2, double> const& a, Vec<2, double> const& b, Vec<2, double> const& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
SCREE_BODY Vec<2, double> Segment::nearest(Vec<2, double> const& x) const {
  Vec<2, double> const along = b - a;
  return a + along * std::clamp((x - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
}
SCREE_BODY bool Segment::is_right_of(Vec<2, double> const& x) const {
  bool const upwards = a[1] <= x[1] && b[1] > x[1], downwards = b[1] <= x[1] && a[1] > x[1];
  return (upwards && turn(a, b, x) > 0) || (downwards && turn(a, b, x) < 0);
}
SCREE_BODY bool Segment::crosses(Segment const& other) const {
  if (a.cwiseMax(b).x() < other.a.cwiseMin(other.b).x() || other.a.cwiseMax(other.b).x() < a.cwiseMin(b).x())
    return false;
  return turn(a, b, other.a) * turn(a, b, other.b) < 0 && turn(other.a, other.b, a) * turn(other.a, other.b, b) < 0;
}
SCREE_BODY double Segment::below(double level) const {
  double const low = std::min(a[1], b[1]), high = std::max(a[1], b[1]), width = b[0] - a[0];
  if (high <= level) return width * (low + high) / 2;
  if (low >= level) return width * level;
  return width * (level - sq(level - low) / (2 * (high - low)));
}

}  // namespace detail

SCREE_BODY Polygon::Polygon(std::vector<Loop> const& loops) {
  double const infinity = std::numeric_limits<double>::infinity();
  Data data;
  data.bounds = {Vec<2, double>::Constant(infinity), Vec<2, double>::Constant(-infinity)};
  for (auto const& loop : loops) add(data.sides, loop);
  if (data.sides.empty()) fail("there is none");
  for (auto const& side : data.sides)
    data.bounds = detail::hull(data.bounds, Box<2>{side.a.cwiseMin(side.b), side.a.cwiseMax(side.b)});
  check_crossings(data.sides);
  for (auto const& loop : loops) data.orientation.push_back(orientation_of(data.sides, loop));
  for (std::size_t k = 0; k < loops.size(); ++k) data.sizes.push_back(loops[k].size());
  data_ = std::make_shared<Data const>(std::move(data));
}
SCREE_BODY double Polygon::signed_distance(Vec<2, double> const& x) const {
  double const distance = (nearest(x) - x).norm();
  return contains(x) ? -distance : distance;
}
SCREE_BODY bool Polygon::contains(Vec<2, double> const& x) const {
  bool odd = false;
  for (auto const& side : data_->sides) odd ^= side.is_right_of(x);
  return odd;
}
SCREE_BODY Vec<2, double> Polygon::nearest(Vec<2, double> const& x) const {
  Vec<2, double> best = data_->sides[0].a;
  for (auto const& side : data_->sides) {
    Vec<2, double> const there = side.nearest(x);
    if ((there - x).squaredNorm() < (best - x).squaredNorm()) best = there;
  }
  return best;
}
SCREE_BODY std::optional<double> Polygon::exact_volume_below(double level) const {
  double area = 0;
  std::size_t side = 0;
  for (std::size_t loop = 0; loop < data_->sizes.size(); ++loop)
    for (std::size_t const end = side + data_->sizes[loop]; side < end; ++side)
      area -= data_->orientation[loop] * data_->sides[side].below(level);
  return area;
}
SCREE_BODY void Polygon::fail(std::string const& why) { throw std::invalid_argument("set-up: a polygon: " + why); }
SCREE_BODY void Polygon::add(std::vector<detail::Segment>& sides, Loop const& loop) {
  if (loop.size() < 3) fail("it needs three corners or more, not " + std::to_string(loop.size()));
  double area = 0, length = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    detail::Segment const side{loop[k], loop[(k + 1) % loop.size()]};
    if (!side.a.allFinite()) fail("corner " + std::to_string(k + 1) + " is not finite");
    if (side.a == side.b) fail("corner " + std::to_string(k + 1) + " is repeated");
    area += detail::turn(loop[0], side.a, side.b), length += (side.b - side.a).norm();
    sides.push_back(side);
  }
  if (!(std::abs(area) > 1e-12 * sq(length))) fail("it has no area");
  if (sides.size() > 20'000) fail("more than 20 000 sides");
}
SCREE_BODY void Polygon::check_crossings(std::vector<detail::Segment> const& sides) {
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (sides[i].crosses(sides[j]))
        fail(detail::formatted("its sides from (%g, %g) to (%g, %g) and from (%g, %g) to (%g, %g) cross", sides[j].a[0],
                               sides[j].a[1], sides[j].b[0], sides[j].b[1], sides[i].a[0], sides[i].a[1], sides[i].b[0],
                               sides[i].b[1]));
}
SCREE_BODY double Polygon::orientation_of(std::vector<detail::Segment> const& sides, Loop const& loop) {
  Vec<2, double> const along = loop[1] - loop[0], left(-along[1], along[0]);
  Vec<2, double> const x = (loop[0] + loop[1]) / 2 + 1e-7 * left;
  bool odd = false;
  for (auto const& side : sides) odd ^= side.is_right_of(x);
  return odd ? 1 : -1;
}

}  // namespace scree
