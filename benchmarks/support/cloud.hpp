// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/setup/lattice.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace scree::bench {

/// Particles for rows without a solver: a square or cube of them on a lattice, displaced by up to a fifth of the
/// spacing, sorted by cells as long as the support, so that neighbours are close in memory.
template <int Dim>
struct Cloud {
  double spacing, smoothing_length, support;  // m
  std::vector<Vec<Dim, double>> points;

  Cloud(int about, double smoothing, double dr = 0.01)
      : spacing(dr), smoothing_length(smoothing * dr), support(2 * smoothing_length) {
    double const edge = dr * std::round(std::pow(double(about), 1.0 / Dim));
    points = fill_lattice(Box<Dim>{Vec<Dim, double>::Zero(), Vec<Dim, double>::Constant(edge)}, dr);
    jitter(points, 0.2 * dr, 1);
    sort(static_cast<std::uint64_t>(edge / support) + 2);
  }

 private:
  void sort(std::uint64_t cells) {
    std::vector<std::pair<std::uint64_t, Vec<Dim, double>>> keyed;
    keyed.reserve(points.size());
    for (auto const& x : points) {
      std::uint64_t key = 0;
      for (int axis = Dim - 1; axis >= 0; --axis)
        key = key * cells + static_cast<std::uint64_t>(std::max(0.0, x[axis]) / support);
      keyed.emplace_back(key, x);
    }
    std::stable_sort(keyed.begin(), keyed.end(), [](auto const& a, auto const& b) { return a.first < b.first; });
    std::transform(keyed.begin(), keyed.end(), points.begin(), [](auto const& entry) { return entry.second; });
  }
};

/// The last cloud of each dimension is kept, because a large one takes seconds to make.
template <int Dim>
Cloud<Dim> const& cloud_of(int about, double smoothing) {
  static std::unique_ptr<Cloud<Dim>> last;
  static std::pair<int, double> made_for;
  if (!last || made_for != std::pair(about, smoothing)) {
    last.reset();
    last = std::make_unique<Cloud<Dim>>(about, smoothing);
    made_for = {about, smoothing};
  }
  return *last;
}

}  // namespace scree::bench
