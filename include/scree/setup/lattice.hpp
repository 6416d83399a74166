// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "../fields/groups.hpp"
#include "cast.hpp"
#include "cells.hpp"
#include "shapes.hpp"

#include <cmath>
#include <random>
#include <vector>

namespace scree {

/// Returns the centres of the cubes of a lattice that are inside a shape; the first coordinate runs fastest. `anchor`
/// (m) is a corner of one of the cubes; shapes filled from the same anchor share one lattice. Throws
/// std::invalid_argument if the spacing is not positive, a parameter of the shape is out of its range, the shape has no
/// finite bounds, or the particles do not fit in memory. All functions that fill shapes or make walls throw for these
/// reasons.
template <Shape S>
std::vector<Vec<S::dim, double>> fill_lattice(S const& shape, double spacing, Vec<S::dim, double> const& anchor) {
  check_shape(shape);
  Box<S::dim> const bounds = shape.bounds();
  detail::Cells<S::dim> const cells(bounds, spacing, anchor);
  return cells.template centres<detail::is_costly<S>>(detail::Filled<S>(shape, bounds, spacing, anchor));
}
/// Returns the centres of the cubes of a lattice that are inside a shape. The lattice is anchored at the low corner of
/// the bounds of the shape, so that particles start half a spacing from its low sides. In a box the number of cubes
/// along each axis is rounded. Throws std::invalid_argument also if a Box, Ball, Cylinder, Polygon, Mesh or Release has
/// no room for a particle.
template <Shape S>
std::vector<Vec<S::dim, double>> fill_lattice(S const& shape, double spacing) {
  check_shape(shape);
  auto points = fill_lattice(shape, spacing, Vec<S::dim, double>(shape.bounds().low));
  detail::check_not_empty(shape, spacing, double(points.size()));
  return points;
}

// If the argument is not a shape, the compiler explains what a shape is.
template <class S, class... Others>
requires(!Shape<S>) std::vector<Vec<3, double>> fill_lattice(S const&, double, Others const&...) {
  static_assert(Shape<S>,
                "this is not a Shape: it needs `dim`, signed_distance(x), which returns a double, contains(x), which "
                "returns a bool, and bounds(), which returns a Box<dim>");
  return {};
}

/// Returns the share of the points of fill_lattice() that one rank of a case owns at its start: consecutive points,
/// equally many on each rank. Points are ordered layer by layer along the last axis. fill_between(), fill_hexagonal()
/// and wall_around() also accept a share.
template <Shape S>
SharedPoints<S::dim> fill_lattice(S const& shape, double spacing, Vec<S::dim, double> const& anchor,
                                  IsShareOfRank auto const& share) {
  check_shape(shape);
  Box<S::dim> const bounds = shape.bounds();
  detail::Cells<S::dim> const cells(bounds, spacing, anchor);
  return cells.template centres<detail::is_costly<S>>(detail::Filled<S>(shape, bounds, spacing, anchor), share);
}
template <Shape S>
SharedPoints<S::dim> fill_lattice(S const& shape, double spacing, IsShareOfRank auto const& share) {
  check_shape(shape);
  auto points = fill_lattice(shape, spacing, Vec<S::dim, double>(shape.bounds().low), share);
  detail::check_not_empty(shape, spacing, double(points.all));
  return points;
}

/// Returns wall particles (m): the points of fill_lattice(outer, spacing) that are not within `inner`.
template <int Dim>
std::vector<Vec<Dim, double>> fill_between(Box<Dim> const& inner, Box<Dim> const& outer, double spacing) {
  inner.check(), outer.check();
  detail::Cells<Dim> const cells(outer, spacing, outer.low);
  return cells.centres([&](auto const&, auto const& x) { return !inner.contains(x); });
}
template <int Dim>
SharedPoints<Dim> fill_between(Box<Dim> const& inner, Box<Dim> const& outer, double spacing,
                               IsShareOfRank auto const& share) {
  inner.check(), outer.check();
  detail::Cells<Dim> const cells(outer, spacing, outer.low);
  return cells.centres([&](auto const&, auto const& x) { return !inner.contains(x); }, share);
}

/// Returns the points that are inside a shape, in the same order.
template <Shape S>
std::vector<Vec<S::dim, double>> points_within(std::vector<Vec<S::dim, double>> const& points, S const& shape) {
  check_shape(shape);
  std::vector<Vec<S::dim, double>> result;
  for (auto const& x : points)
    if (shape.contains(x)) result.push_back(x);
  return result;
}

namespace detail {
template <int Dim>
void jitter(std::vector<Vec<Dim, double>>& points, double distance, std::mt19937_64 random) {
  for (auto& x : points)
    for (int axis = 0; axis < Dim; ++axis)
      x[axis] += distance * (2 * std::ldexp(double(random() >> 11), -53) - 1);  // identical on every standard library
}
}  // namespace detail
/// Displaces every point by a random distance, uniformly distributed up to `distance` (m), in either direction of each
/// axis; the same seed gives the same points.
template <int Dim>
void jitter(std::vector<Vec<Dim, double>>& points, double distance, unsigned seed) {
  detail::jitter(points, distance, std::mt19937_64(seed));
}
/// Displaces the points of a share exactly as jitter() displaces them among all points.
template <int Dim>
void jitter(SharedPoints<Dim>& share, double distance, unsigned seed) {
  std::mt19937_64 random(seed);
  random.discard(static_cast<unsigned long long>(share.first) * Dim);
  detail::jitter(share.points, distance, random);
}

}  // namespace scree

#ifdef SCREE_COMPILED
#define SCREE_LATTICES(Dim)                                                                                \
  SCREE_INSTANCE std::vector<scree::Vec<Dim, double>> scree::fill_lattice(scree::Box<Dim> const&, double); \
  SCREE_INSTANCE std::vector<scree::Vec<Dim, double>> scree::fill_lattice(scree::Box<Dim> const&, double,  \
                                                                          scree::Vec<Dim, double> const&); \
  SCREE_INSTANCE std::vector<scree::Vec<Dim, double>> scree::fill_between(scree::Box<Dim> const&,          \
                                                                          scree::Box<Dim> const&, double)
SCREE_LATTICES(2);
SCREE_LATTICES(3);
#undef SCREE_LATTICES
#endif
