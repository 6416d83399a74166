// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "profiles.hpp"

// Quantities of the whole bed (concentration, volume, losses), and one row of history.csv. SI units.
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
/// `eye`: depth of the point at rest; `active`: of the rigid body limit; `C`: of the particles.
inline Places places(State const& state, std::vector<double> const& C, Surface const& surface, Drum const& drum,
                     double eye, double active) {
  Places found;
  double const reach = std::max(0.1 * surface.bed_depth(drum.radius), 2 * drum.spacing);
  for (std::size_t i : middle(state, drum)) {
    double const depth = surface.depth(state.x[i], state.z[i]), s = surface.s(state.x[i], state.z[i]);
    if (std::hypot(s, depth - eye) < reach) found.core.add(C[i]);
    if (depth < surface_layer(drum)) found.surface.add(C[i]);
    bool const outside = std::hypot(state.x[i], state.z[i]) > 0.9 * drum.radius;
    if (outside && depth > active) found.periphery.add(C[i]);
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

/// SI units, angle in degrees; see the README for the meaning of each.
struct Moment {
  double time = 0, steps = 0, wall_seconds = 0;
  double angle = 0, surface_scatter = 0, surface_speed = 0;
  double bed_depth = 0, active_depth = 0, zero_velocity_depth = 0, peak_shear_rate = 0;
  double number_density = 0, number_density_min = 0, density_descending = 0, density_ascending = 0;
  double centroid_x = 0, centroid_z = 0, largest_radius = 0, zero_stress_fraction = 0;
  double C_mean = 0, C_min = 0, C_max = 0, C_deviation = 0;
  double C_core = 0, C_surface = 0, C_periphery = 0;
  double kinetic_energy = 0, largest_speed = 0, lost = 0, above_surface = 0;
  double intensity = 0, lacey = 0;
};

struct MomentColumn {
  char const* name;
  double Moment::*value;
  char const* unit = "";
};
inline constexpr MomentColumn moment_columns[] = {{"time", &Moment::time, "s"},
                                                  {"steps", &Moment::steps},
                                                  {"wall_seconds", &Moment::wall_seconds, "s"},
                                                  {"angle", &Moment::angle, "degrees"},
                                                  {"surface_scatter", &Moment::surface_scatter, "m"},
                                                  {"surface_speed", &Moment::surface_speed, "m/s"},
                                                  {"bed_depth", &Moment::bed_depth, "m"},
                                                  {"active_depth", &Moment::active_depth, "m"},
                                                  {"zero_velocity_depth", &Moment::zero_velocity_depth, "m"},
                                                  {"peak_shear_rate", &Moment::peak_shear_rate, "1/s"},
                                                  {"number_density", &Moment::number_density},
                                                  {"number_density_min", &Moment::number_density_min},
                                                  {"density_descending", &Moment::density_descending},
                                                  {"density_ascending", &Moment::density_ascending},
                                                  {"centroid_x", &Moment::centroid_x, "m"},
                                                  {"centroid_z", &Moment::centroid_z, "m"},
                                                  {"largest_radius", &Moment::largest_radius, "m"},
                                                  {"zero_stress_fraction", &Moment::zero_stress_fraction},
                                                  {"C_mean", &Moment::C_mean},
                                                  {"C_min", &Moment::C_min},
                                                  {"C_max", &Moment::C_max},
                                                  {"C_deviation", &Moment::C_deviation},
                                                  {"C_core", &Moment::C_core},
                                                  {"C_surface", &Moment::C_surface},
                                                  {"C_periphery", &Moment::C_periphery},
                                                  {"kinetic_energy", &Moment::kinetic_energy, "J"},
                                                  {"largest_speed", &Moment::largest_speed, "m/s"},
                                                  {"lost", &Moment::lost},
                                                  {"above_surface", &Moment::above_surface},
                                                  {"intensity", &Moment::intensity},
                                                  {"lacey", &Moment::lacey}};

/// All entries except wall_seconds, from a state seen clockwise and its mid-chord.
inline Moment moment(State const& state, Surface const& surface, Profile const& chord, Drum const& drum) {
  double const degrees = 180 / std::numbers::pi;
  double const active = active_depth(chord, drum.omega), eye = zero_velocity_depth(chord);
  auto const g = grains(state, drum);
  auto const at = places(state, state.C, surface, drum, eye, active);
  auto const phi = density(state, surface, drum);
  auto const all = bulk(state, surface, drum);
  return {.time = state.time,
          .steps = double(state.steps),
          .angle = surface.angle * degrees,
          .surface_scatter = surface.scatter,
          .surface_speed = chord.surface_speed,
          .bed_depth = surface.bed_depth(drum.radius),
          .active_depth = active,
          .zero_velocity_depth = eye,
          .peak_shear_rate = chord.rows.empty() ? detail::missing() : most_sheared(chord).shear_rate,
          .number_density = phi.interior.value(),
          .number_density_min = phi.interior.lowest(),
          .density_descending = phi.descending.value(),
          .density_ascending = phi.ascending.value(),
          .centroid_x = all.x.value() * (drum.mirrored ? -1 : 1),
          .centroid_z = all.z.value(),
          .largest_radius = all.largest_radius,
          .zero_stress_fraction = all.without_stress,
          .C_mean = g.C.value(),
          .C_min = g.C.lowest(),
          .C_max = g.C.highest(),
          .C_deviation = g.deviation,
          .C_core = at.core.value(),
          .C_surface = at.surface.value(),
          .C_periphery = at.periphery.value(),
          .kinetic_energy = all.kinetic_energy,
          .largest_speed = all.largest_speed,
          .lost = double(all.lost),
          .above_surface = double(all.above_surface),
          .intensity = state.intensity,
          .lacey = state.lacey};
}

/// A row of species.csv: for each size of a list mean, extremes, and the means of Places.
inline std::vector<double> species_row(State const& state, Surface const& surface, Profile const& chord,
                                       Drum const& drum) {
  double const active = active_depth(chord, drum.omega), eye = zero_velocity_depth(chord);
  std::vector<double> row = {state.time};
  for (auto const& C : state.species) {
    Mean all;
    for (std::size_t i = 0; i < state.size(); ++i) all.add(C[i], volume(state, drum, i));
    auto const at = places(state, C, surface, drum, eye, active);
    row.insert(row.end(),
               {all.value(), all.lowest(), all.highest(), at.core.value(), at.surface.value(), at.periphery.value()});
  }
  return row;
}

}  // namespace drum
