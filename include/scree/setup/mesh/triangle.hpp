// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../core/types.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

// Functions of one triangle: its nearest point, the solid angle that it covers, and where rays and segments meet it.
namespace scree::detail {

using Corners = std::array<Vec<3, double>, 3>;

/// Returns the point of a triangle that is nearest to x (Ericson 2005, Real-Time Collision Detection, section 5.1.5).
inline Vec<3, double> nearest_in_triangle(Corners const& abc, Vec<3, double> const& x) {
  auto const& [a, b, c] = abc;
  Vec<3, double> const ab = b - a, ac = c - a, ax = x - a, bx = x - b, cx = x - c;
  double const d1 = ab.dot(ax), d2 = ac.dot(ax);
  if (d1 <= 0 && d2 <= 0) return a;
  double const d3 = ab.dot(bx), d4 = ac.dot(bx);
  if (d3 >= 0 && d4 <= d3) return b;
  double const d5 = ab.dot(cx), d6 = ac.dot(cx);
  if (d6 >= 0 && d5 <= d6) return c;
  double const vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + ab * (d1 / (d1 - d3));
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + ac * (d2 / (d2 - d6));
  if (va <= 0 && d4 >= d3 && d5 >= d6) return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
  double const all = va + vb + vc;
  return a + ab * (vb / all) + ac * (vc / all);
}

/// Returns the part of the full solid angle that a triangle covers as seen from x, positive if x is behind it (van
/// Oosterom & Strackee 1983); 0 in the plane of the triangle.
inline double solid_angle_share(Corners const& abc, Vec<3, double> const& x) {
  Vec<3, double> const a = abc[0] - x, b = abc[1] - x, c = abc[2] - x;
  double const A = a.norm(), B = b.norm(), C = c.norm();
  double const volume = a.dot(Vec<3, double>(b.cross(c)));
  double const rest = A * B * C + a.dot(b) * C + b.dot(c) * A + c.dot(a) * B;
  return std::atan2(volume, rest) / (2 * std::numbers::pi);
}

/// Returns the distance to a triangle along a ray from `from` with the unit vector `along`; infinity if the ray misses
/// the triangle (Moeller & Trumbore 1997).
inline double distance_along_ray(Corners const& abc, Vec<3, double> const& from, Vec<3, double> const& along) {
  double const infinity = std::numeric_limits<double>::infinity();
  Vec<3, double> const ab = abc[1] - abc[0], ac = abc[2] - abc[0], p = along.cross(ac), to = from - abc[0];
  double const determinant = ab.dot(p);
  if (determinant == 0) return infinity;
  double const u = to.dot(p) / determinant;
  if (!(u >= 0 && u <= 1)) return infinity;
  Vec<3, double> const q = to.cross(ab);
  double const v = along.dot(q) / determinant;
  if (!(v >= 0 && u + v <= 1)) return infinity;
  double const t = ac.dot(q) / determinant;
  return t >= 0 ? t : infinity;
}

/// Returns the unit normal of a triangle; zero if it is so narrow that rounding turns the normal by more than 1e-12.
inline Vec<3, double> certain_normal(Corners const& abc) {
  Vec<3, double> const area = Vec<3, double>(abc[1] - abc[0]).cross(Vec<3, double>(abc[2] - abc[0]));
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, (abc[(k + 1) % 3] - abc[k]).squaredNorm());
  double const size = area.norm();
  return size > 1e-3 * longest ? Vec<3, double>(area / size) : Vec<3, double>::Zero();
}
/// Returns 1 if a segment passes through a triangle against its normal, -1 if it passes along the normal, and 0 if it
/// does not pass. Returns no value if this is uncertain, because the segment passes near the border of the triangle or
/// one of its ends is within `margin` (m) of the plane of the triangle.
inline std::optional<int> passes(Corners const& abc, Vec<3, double> const& from, Vec<3, double> const& to,
                                 double margin) {
  Vec<3, double> const ab = abc[1] - abc[0], ac = abc[2] - abc[0], along = to - from, before = from - abc[0];
  Vec<3, double> const normal = ab.cross(ac);
  double const start = normal.dot(before), end = normal.dot(Vec<3, double>(to - abc[0])), near = margin * normal.norm();
  if (std::min(start, end) > near || std::max(start, end) < -near) return 0;
  if (!(std::min(std::abs(start), std::abs(end)) > near)) return std::nullopt;
  Vec<3, double> const q = before.cross(along);
  double const u = ac.dot(q) / (start - end), v = -ab.dot(q) / (start - end);
  double const inner = std::min({u, v, 1 - u - v});
  if (inner < -1e-4) return 0;
  if (!(inner > 1e-4)) return std::nullopt;
  return start > 0 ? 1 : -1;
}

}  // namespace scree::detail
