// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "quantities.hpp"
#include "state.hpp"

#include <numeric>

// The particles as the analysis sees them: the drum turns clockwise, and the ends of a 3D drum are excluded.
namespace drum {

/// The parameters of a case that the analysis needs, SI units.
struct Drum {
  double radius = 0, spacing = 0;
  double support = 0;     ///< radius of the kernel
  double omega = 0;       ///< rad/s, without its sign
  bool mirrored = false;  ///< it turns anticlockwise
  int dimension = 2;
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

}  // namespace drum
