// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "policies.hpp"

#include <scree/neighbours/neighbours.hpp>
#include <scree/setup/lattice.hpp>

#include <cmath>
#include <random>
#include <vector>

// Sets of points on the host, and their transfer to the device.
namespace scree::test {

template <int Dim>
using Points = std::vector<Vec<Dim, double>>;

template <int Dim>
Box<Dim> unit_box() {
  return {Vec<Dim, double>::Zero(), Vec<Dim, double>::Ones()};
}

/// A lattice that fills the unit box, displaced by up to a fraction of its spacing.
template <int Dim>
Points<Dim> lattice(double spacing, double jittered = 0, unsigned seed = 1) {
  auto points = fill_lattice(unit_box<Dim>(), spacing);
  if (jittered > 0) jitter(points, jittered * spacing, seed);
  return points;
}

/// Uniform in a box with edges from low to high.
template <int Dim>
Points<Dim> random_points(int count, double low, double high, unsigned seed) {
  Points<Dim> points(static_cast<std::size_t>(count), Vec<Dim, double>::Constant((low + high) / 2));
  jitter(points, (high - low) / 2, seed);
  return points;
}

/// Whether a point is at least `distance` away from all sides of the unit box.
template <int Dim>
bool deep_inside(Vec<Dim, double> const& x, double distance) {
  return (x.array() >= distance).all() && (x.array() <= 1 - distance).all();
}

template <class P>
Positions<P> positions_of(Points<P::dim> const& points) {
  return array_of<P>(cast<typename P::real>(points));
}

}  // namespace scree::test
