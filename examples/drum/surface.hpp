// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "view.hpp"

#include <limits>
#include <map>

// The free surface of the bed, a straight line in the rolling mode.
namespace drum {

/// A line through the surface, and its frame: s along the surface, downhill, from the point closest to the axis; depth
/// into the bed.
struct Surface {
  double angle = std::numeric_limits<double>::quiet_NaN();  ///< rad, of descent in the direction of x
  double height = 0;                                        ///< m, of the line over the axis, along its normal
  double scatter = 0;                                       ///< m, rms distance of the topmost particles from it
  int columns = 0;                                          ///< with a topmost particle

  double s(double x, double z) const { return x * std::cos(angle) - z * std::sin(angle); }
  double depth(double x, double z) const { return height - (x * std::sin(angle) + z * std::cos(angle)); }
  /// Velocity along the surface, downhill.
  double along(double u, double w) const { return u * std::cos(angle) - w * std::sin(angle); }
  /// Depth of the bed at mid-chord, m.
  double bed_depth(double radius) const { return radius + height; }
};

namespace detail {

/// Topmost particle of each column. Columns are wide enough to hold one particle of the top row at any displacement;
/// they divide the middle of the drum evenly, because the topmost particle of a narrow remainder could be deep.
inline std::vector<std::size_t> topmost(State const& state, Drum const& drum) {
  double const least_density = 0.45;  // below it a particle flies
  double const reach = drum.radius - 3 * drum.spacing, width = 1.5 * drum.spacing;
  long const columns = std::lround(std::floor(drum.radius / 2 / width));  // whole ones on each side of the axis
  auto const column = [&](double x) { return std::lround(std::floor(x / width)); };
  double const middle_width = 2 * half_of_middle(drum), across = std::max(1.0, std::floor(middle_width / width));
  auto const row = [&](double y) { return std::lround(std::floor(std::min(y / middle_width + 0.5, 0.999) * across)); };
  std::map<std::pair<long, long>, std::size_t> top;
  for (std::size_t i : middle(state, drum)) {
    long const k = column(state.x[i]);
    bool const flies = state.number_density[i] < least_density;
    if (flies || k < -columns || k >= columns || std::hypot(state.x[i], state.z[i]) > reach) continue;
    auto const [found, is_new] = top.try_emplace({k, state.y.empty() ? 0 : row(state.y[i])}, i);
    if (!is_new && state.z[i] > state.z[found->second]) found->second = i;
  }
  std::vector<std::size_t> result;
  for (auto const& entry : top) result.push_back(entry.second);
  return result;
}

}  // namespace detail

/// Least squares through the topmost particle of each column within half a radius of the axis, without those near the
/// wall and flying ones. The surface is half a spacing above the centres of these particles.
inline Surface fit_surface(State const& state, Drum const& drum) {
  auto const top = detail::topmost(state, drum);
  Surface surface{.columns = static_cast<int>(top.size())};
  double const n = double(top.size());
  double x = 0, z = 0, xx = 0, xz = 0;
  for (std::size_t i : top) x += state.x[i] / n, z += state.z[i] / n;
  for (std::size_t i : top) xx += (state.x[i] - x) * (state.x[i] - x), xz += (state.x[i] - x) * (state.z[i] - z);
  if (!(xx > 0)) return surface;
  surface.angle = -std::atan(xz / xx);
  surface.height = x * std::sin(surface.angle) + z * std::cos(surface.angle);
  double squares = 0;
  for (std::size_t i : top) squares += std::pow(surface.depth(state.x[i], state.z[i]), 2);
  surface.scatter = std::sqrt(squares / n);
  surface.height += drum.spacing / 2;
  return surface;
}

}  // namespace drum
