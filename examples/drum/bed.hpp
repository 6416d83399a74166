// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "chord_depths.hpp"

// Quantities of the whole bed: concentration, volume, losses. SI units.
namespace drum {

/// A mean, and the extremes of its values; NaN without values.
struct Mean {
  double sum = 0, weight = 0, least = 1e300, largest = -1e300;

  void add(double value, double w = 1) {
    sum += w * value, weight += w;
    least = std::min(least, value), largest = std::max(largest, value);
  }
  double value() const { return sum / weight; }
  double lowest() const { return weight > 0 ? least : detail::missing(); }
  double highest() const { return weight > 0 ? largest : detail::missing(); }
};

struct Grains {
  Mean C;                ///< of all particles, by volume
  double deviation = 0;  ///< root of the mean of (C - mean)^2
};
inline Grains grains(State const& state, Drum const& drum) {
  Grains g;
  for (std::size_t i = 0; i < state.size(); ++i) g.C.add(state.C[i], volume(state, drum, i));
  Mean squares;
  for (std::size_t i = 0; i < state.size(); ++i)
    squares.add(std::pow(state.C[i] - g.C.value(), 2), volume(state, drum, i));
  g.deviation = std::sqrt(squares.value());
  return g;
}

/// C where the paper finds that small and large grains gather.
struct Places {
  Mean core;       ///< around the point of the mid-chord at rest, within a tenth of the bed depth
  Mean surface;    ///< in surface_layer()
  Mean periphery;  ///< within a tenth of the radius from the wall, below the rigid body limit
};
/// `eye`: depth of the point at rest; `active`: of the rigid body limit.
inline Places places(State const& state, Surface const& surface, Drum const& drum, double eye, double active) {
  Places found;
  double const reach = std::max(0.1 * surface.bed_depth(drum.radius), 2 * drum.spacing);
  for (std::size_t i : middle(state, drum)) {
    double const depth = surface.depth(state.x[i], state.z[i]), s = surface.s(state.x[i], state.z[i]);
    if (std::hypot(s, depth - eye) < reach) found.core.add(state.C[i]);
    if (depth < surface_layer(drum)) found.surface.add(state.C[i]);
    bool const outside = std::hypot(state.x[i], state.z[i]) > 0.9 * drum.radius;
    if (outside && depth > active) found.periphery.add(state.C[i]);
  }
  return found;
}

/// Number density, 1 where particles are as close as at the start.
struct Density {
  Mean interior;               ///< deeper than the support of the kernel
  Mean descending, ascending;  ///< of these, the last seventh of the radius on the side where the bed sinks; rises
};
inline Density density(State const& state, Surface const& surface, Drum const& drum) {
  Density found;
  for (std::size_t i : middle(state, drum)) {
    if (!(surface.depth(state.x[i], state.z[i]) > drum.support)) continue;
    found.interior.add(state.number_density[i]);
    if (std::hypot(state.x[i], state.z[i]) < drum.radius * 6 / 7) continue;
    double const s = surface.s(state.x[i], state.z[i]);
    (s > 0 ? found.descending : found.ascending).add(state.number_density[i]);
  }
  return found;
}

/// Position and motion of the bed.
struct Bulk {
  Mean x, z;                  ///< m, of the centre of mass
  double largest_radius = 0;  ///< m
  double largest_speed = 0;   ///< m/s
  double kinetic_energy = 0;  ///< J, in 2D J/m
  double without_stress = 0;  ///< fraction of particles whose pressure is below 0.1 % of rho g R
  /// Beyond the first row of the wall, with no way back; more than three spacings above the surface.
  long lost = 0, above_surface = 0;
};
inline Bulk bulk(State const& state, Surface const& surface, Drum const& drum) {
  Bulk b;
  double const no_pressure = 1e-3 * drum.density * drum.gravity * drum.radius;
  for (std::size_t i = 0; i < state.size(); ++i) {
    double const mass = drum.density * volume(state, drum, i), radius = std::hypot(state.x[i], state.z[i]);
    double const speed = std::hypot(state.u[i], state.v.empty() ? 0 : state.v[i], state.w[i]);
    b.x.add(state.x[i], mass), b.z.add(state.z[i], mass);
    b.largest_radius = std::max(b.largest_radius, radius);
    b.largest_speed = std::max(b.largest_speed, speed);
    b.kinetic_energy += mass * speed * speed / 2;
    if (pressure(state, i) < no_pressure) b.without_stress += 1 / double(state.size());
    if (radius > drum.radius + drum.spacing / 2) ++b.lost;
    if (surface.depth(state.x[i], state.z[i]) < -3 * drum.spacing) ++b.above_surface;
  }
  return b;
}

}  // namespace drum
