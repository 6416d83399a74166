// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "cells.hpp"
#include "shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace scree {

namespace detail {
/// Particles in a plane with the area of each, m^2.
struct PlanePoints {
  std::vector<Vec<2, double>> points;
  std::vector<double> areas;

  void add(Vec<2, double> const& x, double area) {
    points.push_back(x);
    areas.push_back(area);
  }
  /// `count` particles around the origin that share an area.
  void add_ring(double radius, long count, double area) {
    for (long k = 0; k < count; ++k) {
      double const angle = 2 * std::numbers::pi * (double(k) + 0.5) / double(count);
      add({radius * std::cos(angle), radius * std::sin(angle)}, area / double(count));
    }
  }
  /// An annulus of one row whose middle has the given radius.
  void add_annulus(double radius, double spacing) {
    double const circumference = 2 * std::numbers::pi * radius;
    add_ring(radius, std::lround(circumference / spacing), circumference * spacing);
  }
};

/// The middle of a disc, with a radius between 1/2 and 3/2 spacings, where rings would be too tight. At most seven
/// particles, no two of them closer than 0.8 spacings.
inline void add_core(PlanePoints& plane, double radius, double spacing) {
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

/// A disc around the origin: rings from half a spacing within its edge to its core.
inline PlanePoints disc_of_rings(double radius, double spacing) {
  check_spacing(spacing);
  check_memory(std::numbers::pi * sq(radius / spacing), sizeof(Vec<2, double>) + sizeof(double));
  long const rings = std::max(0L, static_cast<long>(std::floor(radius / spacing - 0.5)));
  PlanePoints plane;
  add_core(plane, radius - double(rings) * spacing, spacing);
  for (long ring = rings - 1; ring >= 0; --ring) plane.add_annulus(radius - (double(ring) + 0.5) * spacing, spacing);
  return plane;
}

/// A point of a plane across the axis of a cylinder, moved to a coordinate along the axis.
inline Vec<3, double> lifted(Vec<2, double> const& in_plane, double along, Cylinder const& cylinder) {
  int const first = (cylinder.axis + 1) % 3, second = (cylinder.axis + 2) % 3;
  Vec<3, double> x;
  x[cylinder.axis] = along;
  x[first] = cylinder.centre[first] + in_plane[0];
  x[second] = cylinder.centre[second] + in_plane[1];
  return x;
}
/// Layers of particles along a cylinder; their number is rounded.
inline long layers_of(Cylinder const& cylinder, double spacing) {
  return rounded_count((cylinder.to - cylinder.from) / spacing);
}
inline double layer_position(Cylinder const& cylinder, long layer, double spacing) {
  return cylinder.from + (double(layer) + 0.5) * spacing;
}
}  // namespace detail

/// Particles on rings, with volumes and nominal number that account for the rounded number per ring.
template <int Dim>
struct RingFill {
  std::vector<Vec<Dim, double>> points;  ///< m
  std::vector<double> volumes;           ///< of each particle, m^Dim; close to spacing^Dim
  double nominal_number = 0;             ///< the sum of these volumes over spacing^Dim; compare with points.size()

  /// Adds a particle at x (m) with a volume `size` (m^Dim).
  void add(Vec<Dim, double> const& x, double size, double spacing) {
    points.push_back(x);
    volumes.push_back(size);
    nominal_number += size / math::power<Dim>(spacing);
  }
};

/// Rings of a disc, from half a spacing within its edge inwards, one spacing apart, restricted to a region.
template <Shape Region = Box<2>>
RingFill<2> fill_rings(Ball<2> const& disc, double spacing, Region const& region = whole_space<2>()) {
  disc.check(), check_shape(region);
  detail::PlanePoints const plane = detail::disc_of_rings(disc.radius, spacing);
  detail::check_not_empty(disc, spacing, double(plane.points.size()));
  RingFill<2> result;
  for (std::size_t k = 0; k < plane.points.size(); ++k) {
    Vec<2, double> const x = disc.centre + plane.points[k];
    if (detail::stands_inside(region, x, spacing)) result.add(x, plane.areas[k], spacing);
  }
  return result;
}
/// Rings of a disc in every layer along a cylinder, the first layer half a spacing from its end.
template <Shape Region = Box<3>>
RingFill<3> fill_rings(Cylinder const& cylinder, double spacing, Region const& region = whole_space<3>()) {
  cylinder.check(), check_shape(region);
  detail::PlanePoints const plane = detail::disc_of_rings(cylinder.radius, spacing);
  long const layers = detail::layers_of(cylinder, spacing);
  detail::check_not_empty(cylinder, spacing, double(layers) * double(plane.points.size()));
  double const thickness = (cylinder.to - cylinder.from) / double(layers);
  check_number(double(layers) * double(plane.points.size()));
  RingFill<3> result;
  for (long layer = 0; layer < layers; ++layer)
    for (std::size_t k = 0; k < plane.points.size(); ++k) {
      auto const x = detail::lifted(plane.points[k], detail::layer_position(cylinder, layer, spacing), cylinder);
      if (detail::stands_inside(region, x, spacing)) result.add(x, plane.areas[k] * thickness, spacing);
    }
  return result;
}

}  // namespace scree
