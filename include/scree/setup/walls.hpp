// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "cells.hpp"
#include "rings.hpp"

#include <type_traits>
#include <vector>

// Rows of wall particles. From a particle half a spacing off a wall, a support of 3 spacings (2h with h = 1.5 spacings)
// just reaches the third row.
namespace scree {

namespace detail {
/// As wall_around() says; all points, or a share of them.
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

/// Wall particles within `rows` spacings of a shape, outside of it and inside of `within`, on the lattice of
/// fill_lattice(shape, spacing): together they fill each cell exactly once. Edges of a box come out rounded. If the low
/// side of the shape is at infinity, the lattice is anchored at its high side, or otherwise at that of `within`.
template <Shape S>
std::vector<Vec<S::dim, double>> wall_around(S const& shape, double spacing, int rows, Box<S::dim> const& within) {
  return detail::wall_around(shape, spacing, rows, within);
}
template <Shape S>
SharedPoints<S::dim> wall_around(S const& shape, double spacing, int rows, Box<S::dim> const& within,
                                 IsShareOfRank auto const& share) {
  return detail::wall_around(shape, spacing, rows, within, share);
}
/// Wall particles within `rows` spacings of a shape with finite bounds, all around it.
template <Shape S>
std::vector<Vec<S::dim, double>> wall_around(S const& shape, double spacing, int rows) {
  return detail::wall_around(shape, spacing, rows, whole_space<S::dim>());
}
template <Shape S>
SharedPoints<S::dim> wall_around(S const& shape, double spacing, int rows, IsShareOfRank auto const& share) {
  return detail::wall_around(shape, spacing, rows, whole_space<S::dim>(), share);
}

namespace detail {
/// Rings around a disc at the origin, from half a spacing beyond its edge outwards.
PlanePoints rings_around(double radius, double spacing, int rows);
}  // namespace detail

/// Rings around a disc, from half a spacing beyond its edge outwards, one spacing apart.
std::vector<Vec<2, double>> wall_rings(Ball<2> const& disc, double spacing, int rows);

/// The ends of a cylinder: open or periodic, or closed by discs as thick as the wall around it.
enum class EndWalls { none, discs };

/// Rings around a disc in every layer along a cylinder, aligned with those of fill_rings(); with discs also beyond both
/// ends.
std::vector<Vec<3, double>> wall_rings(Cylinder const& cylinder, double spacing, int rows,
                                       EndWalls ends = EndWalls::none);

}  // namespace scree

#ifndef SCREE_COMPILED
#include "walls.ipp"
#endif
