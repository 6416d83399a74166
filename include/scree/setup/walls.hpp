// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "cells.hpp"
#include "rings.hpp"

#include <type_traits>
#include <vector>

// Rows of wall particles. The support of a particle half a spacing away from a wall, 3 spacings (2h with h = 1.5
// spacings), just reaches the third row.
namespace scree {

namespace detail {
/// Returns all points of wall_around(), or a share of them.
template <Shape S, class... OfWhom>
auto wall_around(S const& shape, double spacing, int rows, Box<S::dim> const& within, OfWhom const&... share) {
  check_shape(shape), within.check();
  check_spacing(spacing);
  check_rows(rows);
  Box<S::dim> const bounds = shape.bounds();
  Vec<S::dim, double> anchor = within.low;
  for (int axis = 0; axis < S::dim; ++axis)
    for (double const edge : {bounds.high[axis], bounds.low[axis]})
      if (std::isfinite(edge)) anchor[axis] = edge;
  Box<S::dim> const region = overlap(grown(bounds, rows * spacing), within);
  Cells<S::dim> const cells(region, spacing, anchor);
  double const nearest = -tie * spacing, farthest = (rows + tie) * spacing;
  if constexpr (std::is_same_v<S, Box<S::dim>>) {
    Filled<S> const filled(shape, region, spacing, anchor);
    return cells.centres(
        [&](auto const& index, Vec<S::dim, double> const& x) {
          return !filled(index, x) && shape.signed_distance(x) <= farthest;
        },
        share...);
  } else {
    RowDistance<S> distance(shape, nearest, farthest);
    return cells.template centres<is_costly<S>>(
        [=](auto const&, Vec<S::dim, double> const& x) mutable {
          double const found = distance(x);
          return found >= nearest && found <= farthest;
        },
        share...);
  }
}
}  // namespace detail

/// Returns wall particles within `rows` spacings of a shape, outside the shape and inside `within`, on the lattice of
/// fill_lattice(shape, spacing): together, material and wall fill each cell exactly once. The outer edges of a wall
/// around a box are rounded. Along each axis the lattice is anchored at the low side of the shape; if this side is at
/// infinity, at the high side of the shape; if both are, at the low side of `within`.
template <Shape S>
std::vector<Vec<S::dim, double>> wall_around(S const& shape, double spacing, int rows, Box<S::dim> const& within) {
  return detail::wall_around(shape, spacing, rows, within);
}
template <Shape S>
SharedPoints<S::dim> wall_around(S const& shape, double spacing, int rows, Box<S::dim> const& within,
                                 IsShareOfRank auto const& share) {
  return detail::wall_around(shape, spacing, rows, within, share);
}
/// Returns wall particles within `rows` spacings of a shape with finite bounds, on all sides of it.
template <Shape S>
std::vector<Vec<S::dim, double>> wall_around(S const& shape, double spacing, int rows) {
  return detail::wall_around(shape, spacing, rows, whole_space<S::dim>());
}
template <Shape S>
SharedPoints<S::dim> wall_around(S const& shape, double spacing, int rows, IsShareOfRank auto const& share) {
  return detail::wall_around(shape, spacing, rows, whole_space<S::dim>(), share);
}

namespace detail {
/// Returns the particles of rings around a disc at the origin. The first ring is half a spacing beyond the edge.
PlanePoints rings_around(double radius, double spacing, int rows);
}  // namespace detail

/// Returns wall particles on rings around a disc. The first ring is half a spacing beyond the edge, and the rings are
/// one spacing apart.
std::vector<Vec<2, double>> wall_rings(Ball<2> const& disc, double spacing, int rows);

/// Walls at the ends of a cylinder: none (open or periodic ends), or discs as thick as the wall around the cylinder.
enum class EndWalls { none, discs };

/// Returns wall particles on rings around a disc in every layer along a cylinder, aligned with the layers of
/// fill_rings(); with EndWalls::discs, also discs beyond both ends.
std::vector<Vec<3, double>> wall_rings(Cylinder const& cylinder, double spacing, int rows,
                                       EndWalls ends = EndWalls::none);

}  // namespace scree

#ifndef SCREE_COMPILED
#include "walls.ipp"
#endif
