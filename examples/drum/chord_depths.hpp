// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "mid_chord.hpp"

// Depths and rates from a profile of the mid-chord. A depth that the profile does not reach is NaN.
namespace drum {

namespace detail {

inline double missing() { return std::numeric_limits<double>::quiet_NaN(); }

/// Depth at which a quantity of the rows first falls to a level, by linear interpolation between the rows.
template <class Value>
double first_below(Profile const& profile, double level, Value const& value) {
  auto const& rows = profile.rows;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    double const above = value(rows[k - 1]) - level, below = value(rows[k]) - level;
    if (above > 0 && below <= 0)
      return rows[k - 1].depth + (rows[k].depth - rows[k - 1].depth) * above / (above - below);
  }
  return missing();
}

}  // namespace detail

/// Velocity minus that of a body that turns with the drum, m/s.
inline double excess(Profile const& profile, ProfileRow const& row, double omega) {
  return row.velocity - omega * (profile.height - row.depth);
}

/// Depth of the rigid body limit, m: below it the excess over rigid rotation is less than 5 % of that of the first row.
inline double active_depth(Profile const& profile, double omega) {
  if (profile.rows.empty()) return detail::missing();
  double const limit = 0.05 * excess(profile, profile.rows.front(), omega);
  return detail::first_below(profile, limit, [&](ProfileRow const& row) { return excess(profile, row, omega); });
}

/// Depth where the velocity along the surface changes its sign, m.
inline double zero_velocity_depth(Profile const& profile) {
  return detail::first_below(profile, 0, [](ProfileRow const& row) { return row.velocity; });
}

/// The row of the largest shear rate; rows must not be empty.
inline ProfileRow const& most_sheared(Profile const& profile) {
  return *std::ranges::max_element(profile.rows, {}, &ProfileRow::shear_rate);
}

/// Mean shear rate in the passive zone, taken from half to nine tenths of the bed depth, 1/s.
inline double passive_shear_rate(Profile const& profile) {
  double sum = 0, particles = 0;
  for (auto const& row : profile.rows) {
    if (row.depth < 0.5 * profile.bed_depth || row.depth > 0.9 * profile.bed_depth) continue;
    sum += row.particles * row.shear_rate, particles += row.particles;
  }
  return sum / particles;
}

/// Depth below which dC/dt from the gradient of V stays under 5 % of its largest magnitude, m; the last tenth of the
/// bed, at the wall, is excluded.
inline double rate_vanishes_at(Profile const& profile) {
  double largest = 0, depth = detail::missing();
  for (auto const& row : profile.rows) largest = std::max(largest, std::abs(row.gradient_V_rate));
  for (auto const& row : profile.rows) {
    if (row.depth < 0.9 * profile.bed_depth && std::abs(row.gradient_V_rate) > 0.05 * largest) depth = row.depth;
  }
  return depth;
}

/// Viscosity of the granular flow at the largest shear rate, Pa s: sqrt(J2) over the shear rate.
inline double granular_viscosity(Profile const& profile) {
  if (profile.rows.empty()) return detail::missing();
  auto const& row = most_sheared(profile);
  return row.shear_stress / row.shear_rate;
}

/// The velocity at a depth, by linear interpolation between the rows.
inline double velocity_at(Profile const& profile, double depth) {
  auto const& rows = profile.rows;
  if (rows.empty()) return detail::missing();
  auto const next = std::ranges::lower_bound(rows, depth, {}, &ProfileRow::depth);
  if (next == rows.begin()) return rows.front().velocity;
  if (next == rows.end()) return rows.back().velocity;
  auto const last = std::prev(next);
  double const part = (depth - last->depth) / (next->depth - last->depth);
  return last->velocity + part * (next->velocity - last->velocity);
}

/// Largest difference between two velocity profiles over the surface speed of the second.
inline double difference(Profile const& a, Profile const& b) {
  double largest = 0;
  for (auto const& row : b.rows) largest = std::max(largest, std::abs(velocity_at(a, row.depth) - row.velocity));
  return largest / std::abs(b.surface_speed);
}

}  // namespace drum
