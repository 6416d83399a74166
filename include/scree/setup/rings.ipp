// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "rings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scree::detail {

SCREE_BODY void PlanePoints::add(Vec<2, double> const& x, double area) {
  points.push_back(x);
  areas.push_back(area);
}
SCREE_BODY void PlanePoints::add_ring(double radius, long count, double area) {
  for (long k = 0; k < count; ++k) {
    double const angle = 2 * std::numbers::pi * (double(k) + 0.5) / double(count);
    add({radius * std::cos(angle), radius * std::sin(angle)}, area / double(count));
  }
}
SCREE_BODY void PlanePoints::add_annulus(double radius, double spacing) {
  double const circumference = 2 * std::numbers::pi * radius;
  add_ring(radius, std::lround(circumference / spacing), circumference * spacing);
}

SCREE_BODY void add_core(PlanePoints& plane, double radius, double spacing) {
  double const area = std::numbers::pi * sq(radius);
  long count = std::lround(area / sq(spacing));
  if (count == 0) return;
  if (radius < 0.75 * spacing) count = 1;  // two would be too close to each other or to the next ring
  long const in_middle = count == 1 || count >= 6 ? 1 : 0, around = count - in_middle;
  if (in_middle == 1) plane.add(Vec<2, double>::Zero(), area / double(count));
  if (around == 0) return;
  double const widest = radius - spacing / 2, tightest = 0.41 * spacing / std::sin(std::numbers::pi / double(around));
  plane.add_ring(std::max(widest, tightest), around, area * double(around) / double(count));
}

SCREE_BODY PlanePoints disc_of_rings(double radius, double spacing) {
  check_spacing(spacing);
  check_memory(std::numbers::pi * sq(radius / spacing), sizeof(Vec<2, double>) + sizeof(double));
  long const rings = std::max(0L, static_cast<long>(std::floor(radius / spacing - 0.5)));
  PlanePoints plane;
  add_core(plane, radius - double(rings) * spacing, spacing);
  for (long ring = rings - 1; ring >= 0; --ring) plane.add_annulus(radius - (double(ring) + 0.5) * spacing, spacing);
  return plane;
}

SCREE_BODY Vec<3, double> lifted(Vec<2, double> const& in_plane, double along, Cylinder const& cylinder) {
  int const first = (cylinder.axis + 1) % 3, second = (cylinder.axis + 2) % 3;
  Vec<3, double> x;
  x[cylinder.axis] = along;
  x[first] = cylinder.centre[first] + in_plane[0];
  x[second] = cylinder.centre[second] + in_plane[1];
  return x;
}

}  // namespace scree::detail
