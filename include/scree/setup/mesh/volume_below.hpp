// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "triangles.hpp"

#include <algorithm>
#include <array>

// The volume below a level inside a closed surface of triangles, by the divergence theorem applied to the field (0, 0,
// min(z, level)), whose divergence is 1 below the level and 0 above.
namespace scree::detail {

/// Returns the mean of min(z, level) over a triangle whose corners have these z, m.
inline double mean_below(std::array<double, 3> z, double level) {
  std::sort(z.begin(), z.end());
  double const mean = (z[0] + z[1] + z[2]) / 3;
  if (z[2] <= level) return mean;
  if (z[0] >= level) return level;
  if (z[1] <= level) {  // the top corner is cut off
    double const over = z[2] - level;
    return mean - over * over * over / (3 * (z[2] - z[0]) * (z[2] - z[1]));
  }
  double const under = level - z[0];
  return level - under * under * under / (3 * (z[1] - z[0]) * (z[2] - z[0]));
}

/// Returns the volume below a level, m^3. All corners may be above the level.
inline double volume_below(Triangles const& mesh, double level) {
  double const base = mesh.vertex(0, 0)[2];  // the surface is closed: any height may be subtracted
  double volume = 0;
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    std::array<double, 3> z{};
    for (std::size_t k = 0; k < 3; ++k) z[k] = mesh.vertex(t, k)[2] - base;
    volume += mesh.area_vector(t)[2] * mean_below(z, level - base);
  }
  return volume;
}

}  // namespace scree::detail
