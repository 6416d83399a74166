// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "bed.hpp"

// One row of history.csv.
namespace drum {

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
};

struct MomentColumn {
  char const* name;
  double Moment::*value;
};
inline constexpr MomentColumn moment_columns[] = {{"time", &Moment::time},
                                                  {"steps", &Moment::steps},
                                                  {"wall_seconds", &Moment::wall_seconds},
                                                  {"angle", &Moment::angle},
                                                  {"surface_scatter", &Moment::surface_scatter},
                                                  {"surface_speed", &Moment::surface_speed},
                                                  {"bed_depth", &Moment::bed_depth},
                                                  {"active_depth", &Moment::active_depth},
                                                  {"zero_velocity_depth", &Moment::zero_velocity_depth},
                                                  {"peak_shear_rate", &Moment::peak_shear_rate},
                                                  {"number_density", &Moment::number_density},
                                                  {"number_density_min", &Moment::number_density_min},
                                                  {"density_descending", &Moment::density_descending},
                                                  {"density_ascending", &Moment::density_ascending},
                                                  {"centroid_x", &Moment::centroid_x},
                                                  {"centroid_z", &Moment::centroid_z},
                                                  {"largest_radius", &Moment::largest_radius},
                                                  {"zero_stress_fraction", &Moment::zero_stress_fraction},
                                                  {"C_mean", &Moment::C_mean},
                                                  {"C_min", &Moment::C_min},
                                                  {"C_max", &Moment::C_max},
                                                  {"C_deviation", &Moment::C_deviation},
                                                  {"C_core", &Moment::C_core},
                                                  {"C_surface", &Moment::C_surface},
                                                  {"C_periphery", &Moment::C_periphery},
                                                  {"kinetic_energy", &Moment::kinetic_energy},
                                                  {"largest_speed", &Moment::largest_speed},
                                                  {"lost", &Moment::lost},
                                                  {"above_surface", &Moment::above_surface}};

/// All entries except wall_seconds, from a state seen clockwise and its mid-chord.
inline Moment moment(State const& state, Surface const& surface, Profile const& chord, Drum const& drum) {
  double const degrees = 180 / std::numbers::pi;
  double const active = active_depth(chord, drum.omega), eye = zero_velocity_depth(chord);
  auto const g = grains(state, drum);
  auto const at = places(state, surface, drum, eye, active);
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
          .above_surface = double(all.above_surface)};
}

}  // namespace drum
