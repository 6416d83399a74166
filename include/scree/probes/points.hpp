// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../kernels/kernel.hpp"
#include "sample.hpp"

#include <stdexcept>

namespace scree {

/// The mean of a field at a point.
template <class Value>
struct PointMean {
  Value value;        ///< NaN if no particle is within a support
  double weight = 0;  ///< $\sum_j V_j W$: about 1 inside the material, 1/2 at a plane surface, 0 far away
};

/// Returns a field of the material at points (m), $X = \sum_j X_j V_j W_j/\sum_j V_j W_j$ over the particles within a
/// support of each point (Shepard 1968). This mean is exact for a constant field and first-order accurate near a
/// surface, where `weight` is below 1. Walls do not contribute; periodic images do. The field may be a derived field,
/// such as `pressure`. Rates and other results of passes belong to the last step or, for observers at the start, to the
/// initial state; before a run, they are zero until solver.update_rates() is called. Computed on the host, with work
/// proportional to the number of particles times the number of points.
template <class S, Field F>
auto mean_at(S const& solver, F, std::vector<Vec<S::policy::dim, double>> const& points) {
  using P = typename S::policy;
  auto const values = detail::sampled<F>(solver);
  using Value = typename decltype(values)::value_type;
  auto const places = detail::sampled<Position>(solver);
  auto const volumes = detail::sampled<Volume>(solver);
  KernelFunction<typename P::kernel, P::dim, double> const kernel(solver.resolution().smoothing_length);
  auto const& periods = solver.settings().periods;
  std::vector<PointMean<Value>> means(points.size(), {detail::zero_of<Value>()});
  for (std::size_t j = 0; j < values.size(); ++j)
    for (std::size_t k = 0; k < points.size(); ++k) {
      double const r = norm(detail::nearest_offset<Vec<P::dim, double>>(points[k], places[j], periods));
      if (!(r < kernel.radius())) continue;
      double const w = volumes[j] * kernel.value(r);
      means[k].value += w * values[j];
      means[k].weight += w;
    }
  for (auto& mean : means) {
    if (mean.weight > 0)
      mean.value /= mean.weight;
    else
      mean.value = detail::nan_of<Value>();
  }
  return means;
}

/// Returns evenly spaced points on a straight line, including both ends. Throws std::invalid_argument for fewer than
/// two points.
template <int Dim>
std::vector<Vec<Dim, double>> points_along(Vec<Dim, double> const& from, Vec<Dim, double> const& to, int number) {
  if (number < 2) throw std::invalid_argument("scree: a line needs at least two points, not " + std::to_string(number));
  std::vector<Vec<Dim, double>> points;
  for (int k = 0; k < number; ++k) points.push_back(from + (to - from) * (double(k) / (number - 1)));
  return points;
}

}  // namespace scree
