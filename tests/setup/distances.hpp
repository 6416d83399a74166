// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/core/types.hpp>

#include <algorithm>
#include <limits>
#include <vector>

// Distances between points, from all pairs.
namespace scree::test {

template <int Dim>
double distance_to(std::vector<Vec<Dim, double>> const& points, Vec<Dim, double> const& x) {
  double least = std::numeric_limits<double>::infinity();
  for (auto const& y : points) least = std::min(least, (x - y).squaredNorm());
  return std::sqrt(least);
}

template <int Dim>
double least_distance(std::vector<Vec<Dim, double>> const& points) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, (points[i] - points[j]).squaredNorm());
  return std::sqrt(least);
}

template <int Dim>
int number_within(std::vector<Vec<Dim, double>> const& points, Vec<Dim, double> const& x, double distance) {
  return static_cast<int>(
      std::count_if(points.begin(), points.end(), [&](auto const& y) { return (x - y).norm() <= distance; }));
}

/// Whether two sets hold the same points in any order, to a tolerance below half their spacing.
template <int Dim>
bool same_points(std::vector<Vec<Dim, double>> const& a, std::vector<Vec<Dim, double>> const& b, double tolerance) {
  if (a.size() != b.size()) return false;
  auto const once = [&](auto const& x) { return number_within(b, x, tolerance) == 1; };
  return std::all_of(a.begin(), a.end(), once);
}

template <int Dim>
std::vector<Vec<Dim, double>> joined(std::vector<Vec<Dim, double>> a, std::vector<Vec<Dim, double>> const& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace scree::test
