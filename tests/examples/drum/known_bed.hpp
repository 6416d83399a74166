// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <drum/tables.hpp>

#include <numbers>
#include <random>

/// A bed whose surface, velocities and fields are known functions of the depth, on a displaced lattice. The analysis
/// must reproduce these functions.
namespace bed {

inline constexpr double degree = std::numbers::pi / 180;

struct Known {
  double radius = 0.035, spacing = 0.5e-3;
  double angle = 22 * degree;
  double depth = 0.0294;  // of the bed at mid-chord, m
  double omega = std::numbers::pi / 6;
  double surface_excess = 0.06;  // m/s, over rigid rotation at the surface
  double active = 0.010;         // m, where that excess ends
  double jitter = 0.1;           // of the spacing
  bool mirrored = false;

  double height() const { return depth - radius; }
  double s(double x, double z) const { return x * std::cos(angle) - z * std::sin(angle); }
  double depth_of(double x, double z) const { return height() - x * std::sin(angle) - z * std::cos(angle); }

  /// Velocity relative to rigid rotation, and the magnitude of its derivative.
  double excess(double d) const { return d < active ? surface_excess * std::pow(1 - d / active, 2) : 0; }
  double shear(double d) const { return d < active ? 4e3 * d / active * (1 - d / active) : 0; }  // peaks at active/2
  double velocity(double d) const { return omega * (height() - d) + excess(d); }
  double C(double d) const { return 0.3 + 10 * d; }
  double gradient_V_rate(double d) const { return d < active ? (d - active / 4) * (1 - d / active) : 0; }
  double pressure(double d) const { return 1500 * 9.81 * d * std::cos(angle); }
};

inline drum::Drum drum_of(Known const& k) {
  return {.radius = k.radius,
          .spacing = k.spacing,
          .support = 3 * k.spacing,
          .omega = k.omega,
          .mirrored = k.mirrored,
          .density = 1500,
          .gravity = 9.81,
          .sound_speed = 10};
}

/// One particle with the known fields; in a mirrored bed as seen from behind.
inline void add(drum::State& state, Known const& k, double x, double z) {
  double const d = k.depth_of(x, z), along = k.velocity(d), into = k.omega * k.s(x, z);
  double const side = k.mirrored ? -1 : 1;
  state.x.push_back(side * x), state.z.push_back(z);
  state.u.push_back(side * (along * std::cos(k.angle) - into * std::sin(k.angle)));
  state.w.push_back(-along * std::sin(k.angle) - into * std::cos(k.angle));
  state.C.push_back(k.C(d)), state.shear_rate.push_back(k.shear(d));
  state.number_density.push_back(std::min(1.0, 0.5 + d / k.spacing / 6));
  state.V.push_back(1e-5 * d), state.D.push_back(1e-8 * d);
  state.gradient_V_rate.push_back(k.gradient_V_rate(d));
  state.gradient_C_rate.push_back(2 * d), state.diffusion_rate.push_back(3 * d);
  double const p = k.pressure(d), tau = 0.3 * p;
  for (double value : {-p, -p, -p, 0.0, 0.0, side * tau}) state.stress.push_back(value);
}

inline drum::State state_of(Known const& k) {
  drum::State state;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> offset(-k.jitter * k.spacing, k.jitter * k.spacing);
  int const reach = int(k.radius / k.spacing) + 1;
  for (int row = 0; row <= 2 * reach; ++row) {
    for (int column = -reach; column <= reach; ++column) {
      // A lattice along the surface, its first row half a spacing deep, as in a settled bed.
      double const d = (row + 0.5) * k.spacing + offset(random), s = (column + 0.5) * k.spacing + offset(random);
      double const up = k.height() - d;
      if (std::hypot(s, up) > k.radius - k.spacing / 2) continue;
      add(state, k, s * std::cos(k.angle) + up * std::sin(k.angle), -s * std::sin(k.angle) + up * std::cos(k.angle));
    }
  }
  return state;
}

}  // namespace bed
