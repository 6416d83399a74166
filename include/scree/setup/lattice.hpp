// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"

#include <cmath>
#include <random>
#include <vector>

namespace scree {

/// A block aligned with the axes, m.
template <int Dim>
struct Box {
  Vec<Dim, double> low, high;
  bool contains(Vec<Dim, double> const& x) const {
    return (x.array() > low.array()).all() && (x.array() < high.array()).all();
  }
};

namespace detail {
/// Centres of cubes of the given edge that fill the box; the number along each axis is rounded.
template <int Dim, class Keep>
std::vector<Vec<Dim, double>> cell_centres(Box<Dim> const& box, double edge, Keep const& keep) {
  long count[Dim], total = 1;
  for (int axis = 0; axis < Dim; ++axis) {
    count[axis] = std::lround((box.high[axis] - box.low[axis]) / edge);
    total *= count[axis];
  }
  std::vector<Vec<Dim, double>> points;
  for (long cell = 0; cell < total; ++cell) {
    Vec<Dim, double> x;
    long rest = cell;
    for (int axis = 0; axis < Dim; rest /= count[axis], ++axis)
      x[axis] = box.low[axis] + edge * (double(rest % count[axis]) + 0.5);
    if (keep(x)) points.push_back(x);
  }
  return points;
}
}  // namespace detail

/// Particles at the centres of cubes that fill a box, the first coordinate running fastest.
template <int Dim>
std::vector<Vec<Dim, double>> fill(Box<Dim> const& box, double spacing) {
  return detail::cell_centres(box, spacing, [](auto const&) { return true; });
}

/// Wall particles on the same lattice: those of `outer` that are not within `inner`.
template <int Dim>
std::vector<Vec<Dim, double>> fill_between(Box<Dim> const& inner, Box<Dim> const& outer, double spacing) {
  return detail::cell_centres(outer, spacing, [&](auto const& x) { return !inner.contains(x); });
}

/// Displaces every point by up to `distance` (m) along each axis, uniformly; the same seed gives the same points.
template <int Dim>
void jitter(std::vector<Vec<Dim, double>>& points, double distance, unsigned seed) {
  std::mt19937_64 random(seed);
  for (auto& x : points)
    for (int axis = 0; axis < Dim; ++axis)
      x[axis] += distance * (2 * std::ldexp(double(random() >> 11), -53) - 1);  // the same on every standard library
}

/// The same points in another precision.
template <class Real, int Dim>
std::vector<Vec<Dim, Real>> cast(std::vector<Vec<Dim, double>> const& points) {
  std::vector<Vec<Dim, Real>> result;
  result.reserve(points.size());
  for (auto const& x : points) result.push_back(x.template cast<Real>());
  return result;
}

}  // namespace scree
