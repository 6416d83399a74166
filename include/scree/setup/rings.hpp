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
/// Particles in a plane, m, and their areas, m^2.
struct PlanePoints {
  std::vector<Vec<2, double>> points;
  std::vector<double> areas;

  void add(Vec<2, double> const& x, double area);
  /// Adds `count` particles on a ring around the origin; each has an equal part of an area, m^2.
  void add_ring(double radius, long count, double area);
  /// Adds a ring of particles with this radius, in the middle of an annulus that is one spacing wide.
  void add_annulus(double radius, double spacing);
};

/// Adds the core of a disc, whose radius is between 1/2 and 3/2 spacings, so that rings would be too tight. The core
/// has at most seven particles, no two of which are closer than 0.8 spacings.
void add_core(PlanePoints& plane, double radius, double spacing);

/// Returns the particles of a disc around the origin: rings around a core, the outermost half a spacing inside the
/// edge.
PlanePoints disc_of_rings(double radius, double spacing);

/// Returns a point in space, given its place in a plane across the axis of a cylinder and its coordinate along the
/// axis.
Vec<3, double> lifted(Vec<2, double> const& in_plane, double along, Cylinder const& cylinder);
/// Returns the number of layers of particles along a cylinder, rounded.
inline long layers_of(Cylinder const& cylinder, double spacing) {
  return rounded_count((cylinder.to - cylinder.from) / spacing);
}
inline double layer_position(Cylinder const& cylinder, long layer, double spacing) {
  return cylinder.from + (double(layer) + 0.5) * spacing;
}
}  // namespace detail

/// Particles on rings. Their volumes and their nominal number account for the rounding of the number of particles per
/// ring.
template <int Dim>
struct RingFill {
  std::vector<Vec<Dim, double>> points;  ///< m
  std::vector<double> volumes;           ///< of each particle, m^Dim; close to spacing^Dim
  double nominal_number = 0;             ///< sum of the volumes over spacing^Dim; compare with points.size()

  /// Adds a particle at x (m) with a volume `size` (m^Dim).
  void add(Vec<Dim, double> const& x, double size, double spacing) {
    points.push_back(x);
    volumes.push_back(size);
    nominal_number += size / math::power<Dim>(spacing);
  }
};

/// Returns the particles inside a region on the rings of a disc. The outermost ring is half a spacing within the edge,
/// and the rings are one spacing apart.
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
/// Returns the particles inside a region on the rings of a disc in every layer along a cylinder. The first layer is
/// half a spacing from the end `from` of the cylinder.
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

#ifndef SCREE_COMPILED
#include "rings.ipp"
#endif
