// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "cells.hpp"

#include <cmath>
#include <vector>

namespace scree {

namespace detail {
/// A hexagonal lattice: rows of particles, each shifted by half a particle distance relative to the next row; in 3D,
/// layers of rows in hexagonal close packing, stacked along the last coordinate. All six (in 3D twelve) nearest
/// neighbours of a particle are at the same distance.
template <int Dim>
struct HexagonalLattice {
  Vec<Dim, double> corner, pitch;  // m; pitch: between particles of a row, between rows, between layers

  /// Computes the distance a of neighbours from the area $\sqrt{3}/2 \, a^2$ or, in 3D, the volume $a^3/\sqrt{2}$ of a
  /// particle.
  HexagonalLattice(Vec<Dim, double> const& low, double spacing) : corner(low) {
    double const distance = spacing * (Dim == 2 ? std::sqrt(2 / std::sqrt(3.0)) : std::pow(2.0, 1.0 / 6));
    pitch[0] = distance;
    pitch[1] = distance * std::sqrt(3.0) / 2;
    if (Dim == 3) pitch[Dim - 1] = distance * std::sqrt(2.0 / 3);
  }
  /// Returns the position of a particle, m. The shifts of rows are centred on half a pitch, so that opposite sides of a
  /// box are alike.
  Vec<Dim, double> position(Index<Dim> const& index) const {
    long const row = index[1], layer = Dim == 3 ? index[Dim - 1] : 0;
    Vec<Dim, double> in_pitches = Vec<Dim, double>::Constant(0.5);
    in_pitches[0] = (row + layer) % 2 == 0 ? 0.25 : 0.75;
    if (Dim == 3) in_pitches[1] = layer % 2 == 0 ? 1.0 / 3 : 2.0 / 3;
    for (int axis = 0; axis < Dim; ++axis) in_pitches[axis] += double(index[static_cast<std::size_t>(axis)]);
    return corner + pitch.cwiseProduct(in_pitches);
  }
};
/// Calls fill(first, last, place) with the range of indices of the lattice around a shape, and returns its result.
template <Shape S, class Fill>
auto fill_hexagonal(S const& shape, double spacing, Fill const& fill) {
  static constexpr int dim = S::dim;
  check_shape(shape);
  check_spacing(spacing);
  Box<dim> const bounds = shape.bounds();
  check_finite(bounds);
  HexagonalLattice<dim> const lattice(bounds.low, spacing);
  Index<dim> first{}, last{};
  for (int axis = 0; axis < dim; ++axis)
    last[static_cast<std::size_t>(axis)] =
        rounded_count(std::ceil((bounds.high[axis] - bounds.low[axis]) / lattice.pitch[axis]));
  return fill(first, last, [&](Index<dim> const& index, Vec<dim, double>& x) {
    x = lattice.position(index);
    return stands_inside(shape, x, spacing);
  });
}
}  // namespace detail

/// Returns particles on a hexagonal lattice within a shape; each particle represents spacing^Dim (m^Dim). Rows are
/// along the first axis. Across them, the lattice starts half a pitch from the low side of the bounds; in 3D, this is
/// the mean over the layers.
template <Shape S>
std::vector<Vec<S::dim, double>> fill_hexagonal(S const& shape, double spacing) {
  auto points = detail::fill_hexagonal(shape, spacing, [](auto const& first, auto const& last, auto const& place) {
    return detail::points_at<S::dim>(first, last, place);
  });
  detail::check_not_empty(shape, spacing, double(points.size()));
  return points;
}
/// Returns a rank's share of the points of a hexagonal lattice in a shape (fields/shared_points.hpp).
template <Shape S>
SharedPoints<S::dim> fill_hexagonal(S const& shape, double spacing, IsShareOfRank auto const& share) {
  return detail::fill_hexagonal(shape, spacing, [&](auto const& first, auto const& last, auto const& place) {
    return detail::share_at<S::dim>(first, last, place, share);
  });
}

}  // namespace scree
