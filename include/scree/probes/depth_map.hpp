// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"
#include "../fields/standard.hpp"
#include "../setup/terrain/raster.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace scree {

/// Returns the vertical depth (m) of particles at the points of a raster: volume divided by area. The values of the
/// raster are not used. Each particle distributes its volume (m^3) to the four points around it, with bilinear weights.
/// The depths times the area of a cell therefore add up to the volume of the particles above the raster, which extends
/// half a cell beyond its outermost points. Choose a raster spacing larger than the particle spacing. Computed on the
/// host.
template <class Positions, class Volumes>
Raster depth_map(Raster const& like, Positions const& positions, Volumes const& volumes) {
  Raster map = like;
  map.values.assign(map.values.size(), 0.0);
  double const area = sq(map.spacing);
  for (std::size_t k = 0; k < positions.size(); ++k) {
    double const u = (double(positions[k][0]) - map.x) / map.spacing,
                 v = (double(positions[k][1]) - map.y) / map.spacing;
    if (!(u >= -0.5 && v >= -0.5 && u < map.columns - 0.5 && v < map.rows - 0.5)) continue;
    double const s = std::clamp(u, 0.0, map.columns - 1.0), t = std::clamp(v, 0.0, map.rows - 1.0);
    int const i = std::min(int(s), map.columns - 2), j = std::min(int(t), map.rows - 2);
    for (int const dj : {0, 1})
      for (int const di : {0, 1}) {
        double const share = (di == 0 ? 1 - (s - i) : s - i) * (dj == 0 ? 1 - (t - j) : t - j);
        map.values[std::size_t(j + dj) * std::size_t(map.columns) + std::size_t(i + di)] +=
            share * double(volumes[k]) / area;
      }
  }
  return map;
}
/// Returns the depth (m) of the material of a solver at the points of a raster.
template <class S>
Raster depth_map(Raster const& like, S const& solver) {
  using namespace fields;
  auto const [x, volumes] = solver.whole().values(position, volume);
  return depth_map(like, x, volumes);
}

}  // namespace scree
