// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../../examples/inclined_flow/layer.hpp"
#include "granular.hpp"

#include <vector>

// A layer that is periodic down the slope, on a rough floor.
namespace scree::test::inclined {

using ::inclined_flow::Bagnold;

struct Slope {
  double angle = 22;              ///< degrees
  int rows = 20;                  ///< of particles over the depth
  double viscosity_speed = 0.05;  ///< alpha c_s, m/s
  double cfl = 0.3;               ///< step over h/c_s
};
/// Walls with (4.3) of Zhu et al. (2024), its sign corrected: only the diagonal of the stress is continued.
template <class Rho>
struct DiagonalStress {
  Rho rho;
  Gravity gravity;
  using reads = Fields<Acceleration>;
  using writes = Fields<Stress>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& wall, T const& total, O& out) const {
    using namespace fields;
    using vector = std::remove_cvref_t<decltype(wall[acceleration])>;
    using Packed = std::remove_cvref_t<decltype(out[stress])>;
    out[stress] = zero<Packed>();
    if (!(total[weight] > 0)) return;
    vector const weight_force = adami::mean_density(rho, total) * (gravity.vector<vector>() - wall[acceleration]);
    out[stress] = walls::continued<Packed, vector>(total[WeightedSum<Stress>{}] / total[weight], weight_force,
                                                   total[weighted_offset] / total[weight]);
  }
};
struct DiagonalWalls : ExtrapolatedWalls<DiagonalStress> {};

inline double const grain = 0.5e-3, depth = 10 * grain, sound_speed = 4;  // m, m, m/s

inline Bagnold exact(Slope const& slope) {
  return {.law = beads(sound_speed, grain), .angle = degrees(slope.angle), .depth = depth, .gravity = g};
}

template <class Walls, class Strain>
struct ControlledModels : GranularModels {
  using law = VolumeMemory<MuOfI<>>;
  using volume_control = VolumeConsistency;
  using walls = Walls;
  using strain = Strain;
};
template <class Walls, class Strain = PlainStrain>
using Controlled = Granular<ControlledModels<Walls, Strain>>;
template <class Walls>
struct FreeModels : GranularModels {
  using walls = Walls;
};
template <class Walls>
using Free = Granular<FreeModels<Walls>>;

/// Initial stress of steady flow, limited to the strength of the material at rest (`moving`: all of it), and the
/// velocity as a function of the height (m, m/s).
template <class Physics, class Integrator = Midpoint, class Profile>
Solver<GranularCase<2, Physics, double, Integrator>> layer(Slope const& slope, bool moving, Profile const& u) {
  using namespace fields;
  Bagnold const flow = exact(slope);
  double const dr = depth / slope.rows, length = 10 * dr;
  Physics physics;
  physics.law = {flow.law};
  physics.gravity = {g, flow.angle};
  physics.viscosity_speed = slope.viscosity_speed;
  physics.cfl = slope.cfl;
  Solver<GranularCase<2, Physics, double, Integrator>> solver(
      {.spacing = dr, .physics = physics, .periods = {{0, 0, length}}},
      fill_lattice(Box<2>{{0, 0}, {length, depth}}, dr), fill_lattice(Box<2>{{0, -4 * dr}, {length, 0}}, dr));
  double const ratio = std::min(std::tan(flow.angle), moving ? 1.0 : 0.99 * friction_ratio(flow.law.mu_s));
  solver.set(stress, [&](auto const& x) {
    double const p = flow.pressure(x[1]);
    return Vec<4, double>(-p, -p, -p, ratio * p);
  });
  solver.set(velocity, [&](auto const& x) { return Vec<2, double>(u(x[1]), 0); });
  return solver;
}

/// Mean velocity down the slope, m/s.
template <class S>
double mean_velocity(S const& solver) {
  auto const u = solver.material().to_host(fields::velocity);
  double sum = 0;
  for (auto const& each : u) sum += each[0];
  return sum / double(u.size());
}

/// Largest deviation from the exact profile in the core, 0.2 to 0.8 of the depth, relative to the exact velocity there;
/// velocities averaged over slices as thick as a row. The rows below are influenced by the floor; those above lack half
/// of their neighbours.
template <class S>
double deviation(S const& solver, Slope const& slope) {
  using namespace fields;
  Bagnold const flow = exact(slope);
  auto const x = solver.material().to_host(position);
  auto const u = solver.material().to_host(velocity);
  std::vector<double> found(std::size_t(slope.rows)), expected(found.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    double const part = x[i][1] / depth;
    if (part < 0.2 || part > 0.8) continue;
    auto const slice = std::size_t(part * slope.rows);
    found[slice] += u[i][0], expected[slice] += flow.velocity(x[i][1]);
  }
  double worst = 0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (expected[k] == 0) continue;
    double const off = found[k] / expected[k] - 1;
    if (!(std::abs(off) <= std::abs(worst))) worst = off;  // a NaN is kept
  }
  return worst;
}

/// deviation() of the mean velocity over `time` (s) from now on.
template <class S>
double deviation_of_mean(S& solver, Slope const& slope, double time) {
  using namespace fields;
  Bagnold const flow = exact(slope);
  std::vector<double> found(std::size_t(slope.rows)), expected(found.size());
  auto const add = [&](S const& now) {
    auto const x = now.material().to_host(position), u = now.material().to_host(velocity);
    for (std::size_t i = 0; i < x.size(); ++i) {
      double const part = x[i][1] / depth;
      if (part < 0.2 || part > 0.8) continue;
      auto const slice = std::size_t(part * slope.rows);
      found[slice] += u[i][0], expected[slice] += flow.velocity(x[i][1]);
    }
  };
  double const start = solver.time();
  for (int k = 1; k <= 100; ++k) {
    solver.run(start + k * time / 100);
    add(solver);
  }
  double worst = 0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    double const off = expected[k] == 0 ? 0 : found[k] / expected[k] - 1;
    if (!(std::abs(off) <= std::abs(worst))) worst = off;
  }
  return worst;
}

}  // namespace scree::test::inclined
