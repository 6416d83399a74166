// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "options.hpp"
#include "state.hpp"

#include <limits>
#include <map>
#include <numeric>

// The particles as the analysis sees them: plain numbers on the host, SI units, in the order of the particles. The drum
// turns clockwise, and the ends of a 3D drum are excluded. The free surface of the bed is a straight line in the
// rolling mode.
namespace drum {

/// The parameters of a case that the analysis needs, SI units.
struct Drum {
  double radius = 0, spacing = 0;
  double support = 0;     ///< radius of the kernel
  double omega = 0;       ///< rad/s, without its sign
  bool mirrored = false;  ///< it turns anticlockwise
  int dimension = 2;
  int species = 0;    ///< sizes of a list; 0: without a list
  double length = 0;  ///< m, in 3D
  double density = 0, gravity = 0;
  double sound_speed = 0;
};

inline Drum drum_of(Options const& o) {
  double const omega = angular_velocity(o);
  return {.radius = o.geometry.radius,
          .spacing = o.numerics.spacing,
          .support = 2 * smoothing_length(o),
          .omega = std::abs(omega),
          .mirrored = omega < 0,
          .dimension = o.numerics.dimension,
          .species = o.species.count(),
          .length = o.geometry.length,
          .density = o.material.density,
          .gravity = o.geometry.gravity,
          .sound_speed = sound_speed(o)};
}

/// The state seen from the side from which the drum turns clockwise.
inline State seen_clockwise(State state, Drum const& drum) {
  if (!drum.mirrored) return state;
  for (double& x : state.x) x = -x;
  for (double& u : state.u) u = -u;
  for (std::size_t k = 3; k < state.stress.size(); k += 6) state.stress[k] *= -1, state.stress[k + 2] *= -1;
  return state;
}

/// Half the length along the axis that the analysis of a 3D drum covers, m: the middle third, at least two spacings,
/// where end walls have the least influence.
inline double half_of_middle(Drum const& drum) { return std::max(drum.length / 6, drum.spacing); }

/// Indices of the particles used for surface, profiles and radial means: all in 2D; in 3D those in the middle.
inline std::vector<std::size_t> middle(State const& state, Drum const& drum) {
  std::vector<std::size_t> all(state.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  if (drum.dimension == 2) return all;
  double const reach = half_of_middle(drum);
  std::erase_if(all, [&](std::size_t i) { return std::abs(state.y[i]) > reach; });
  return all;
}

inline double pressure(State const& state, std::size_t i) {
  double const* s = &state.stress[6 * i];
  return -(s[0] + s[1] + s[2]) / 3;
}

/// sqrt(J2), Pa.
inline double shear_stress(State const& state, std::size_t i) {
  double const* s = &state.stress[6 * i];
  double const p = pressure(state, i);
  double const normal = (s[0] + p) * (s[0] + p) + (s[1] + p) * (s[1] + p) + (s[2] + p) * (s[2] + p);
  return std::sqrt(normal / 2 + s[3] * s[3] + s[4] * s[4] + s[5] * s[5]);
}

/// m^Dim.
inline double volume(State const& state, Drum const& drum, std::size_t i) {
  return state.volume.empty() ? std::pow(drum.spacing, drum.dimension) : state.volume[i];
}

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
