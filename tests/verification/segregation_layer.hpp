// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <support/formulations.hpp>

#include <numeric>

// A layer of height 1 at rest on a floor, seven particles wide and periodic.
namespace scree::test {

inline int const layer_width = 7;  // spacings; a period is longer than two supports

template <class P>
struct SegregatingLayer {
  double spacing;
  Solver<P> solver;
  std::vector<double> heights;  ///< of the particles' lattice cells
  std::vector<double> start;    ///< concentrations

  /// The mean over all lattice rows of |mean of C over the row - its exact mean|.
  template <class Exact>
  double error(Exact const& exact) const {
    std::vector<double> difference(std::size_t(std::lround(1 / spacing)));
    auto const C = concentrations_of(solver);
    double const in_row = double(C.size()) / double(difference.size());
    for (std::size_t i = 0; i < C.size(); ++i)
      difference[std::size_t(heights[i] / spacing)] += (C[i] - mean_over_cell(exact, heights[i], spacing)) / in_row;
    double sum = 0;
    for (double const each : difference) sum += std::abs(each);
    return sum / double(difference.size());
  }
  /// Relative difference between the sum of C and that of the start.
  double lost() const { return std::abs(sum_of(concentrations_of(solver)) / sum_of(start) - 1); }

  template <class Exact>
  static double mean_over_cell(Exact const& exact, double z, double spacing) {
    int const parts = 100;
    double sum = 0;
    for (int k = 0; k < parts; ++k) sum += exact(z + ((k + 0.5) / parts - 0.5) * spacing) / parts;
    return std::clamp(sum, 0.0, 1.0);
  }
};

/// `jittered`: displacement of the particles, in spacings. The start is a function of the height.
template <class P, class Start>
SegregatingLayer<P> segregating_layer(double spacing, double jittered, typename P::physics const& physics,
                                      Start const& start) {
  constexpr int up = P::dim - 1;
  Vec<P::dim, double> low = Vec<P::dim, double>::Zero(), high = Vec<P::dim, double>::Constant(layer_width * spacing);
  std::vector<Period> periods;
  for (int axis = 0; axis < up; ++axis) periods.push_back({.axis = axis, .low = 0, .high = high[axis]});
  high[up] = 1;
  Bed<P::dim> bed{fill_lattice(Box<P::dim>{low, high}, spacing), {}};
  low[up] = -4 * spacing, high[up] = 0;
  bed.wall = fill_lattice(Box<P::dim>{low, high}, spacing);
  std::vector<double> heights, values;
  for (auto const& x : bed.material) {
    heights.push_back(x[up]);
    values.push_back(SegregatingLayer<P>::mean_over_cell(start, x[up], spacing));
  }
  if (jittered > 0) jitter(bed.material, jittered * spacing, 1);
  SegregatingLayer<P> layer{spacing, solver_of<P>(bed, spacing, physics, {}, periods), heights, values};
  std::size_t next = 0;
  set_field(layer.solver, fields::concentration, [&](auto const&) { return values[next++]; });
  return layer;
}

}  // namespace scree::test
