// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "granular.hpp"

#include <algorithm>
#include <string>
#include <vector>

// A column at rest between smooth walls on a rough floor: 40 x 20 particles under their own weight.
namespace scree::test::column {

inline double const spacing = 1e-3, width = 0.04, height = 0.02, sound_speed = 10;  // m, m/s

/// Walls as (4.3) of Zhu et al. (2024) prints them: the weight of the material in between has the opposite sign.
struct PrintedWalls : AdamiWalls {
  template <class Rho>
  auto stress_passes(Rho const& rho, Gravity const& gravity) const {
    return AdamiWalls::stress_passes(rho, Gravity{-gravity.magnitude, gravity.inclination});
  }
};

/// Slip walls that still carry shear stress, as a literal reading of (4.3) has it for all walls: they excite an
/// oscillation of the bed.
struct HoldingWalls : AdamiWalls {
  struct Seen : adami::Seen {
    using provides = Merge<adami::Seen::provides, Fields<Stress>>;
    using reads = Merge<adami::Seen::reads, Fields<Stress, SlipNormal>>;
    using adami::Seen::operator();
    template <class I, class J>
    SCREE_FN auto operator()(Stress, I const&, J const& j) const {
      using namespace fields;
      // Mirrored a second time.
      using Packed = std::remove_cvref_t<decltype(j[stress])>;
      return walls::reflected<Packed>(j[stress], j[slip_normal]);
    }
  };
  template <class Rho>
  Seen lens(Rho const&, Gravity const&) const {
    return {};
  }
};

struct Start {
  double K0 = 0.6;
  double viscosity_speed = 1;  ///< alpha c_s with alpha = 0.1, m/s
};

template <class Physics>
Solver<GranularCase<2, Physics>> at_rest(Start const& start) {
  using namespace fields;
  using P = GranularCase<2, Physics>;
  double const dr = spacing;
  Physics physics;
  physics.law = beads(sound_speed);
  physics.viscosity_speed = start.viscosity_speed;
  physics.cfl = 0.1;
  Box<2> const bed{{0, 0}, {width, height}}, open{{0, 0}, {width, height + 20 * dr}};
  Box<2> const outer{{-3 * dr, -3 * dr}, {width + 3 * dr, height + 10 * dr}};
  auto const wall = fill_between(open, outer, dr);
  Solver<P> solver({.spacing = dr, .physics = physics}, fill_lattice(bed, dr), wall);
  Geostatic const stress_there{height, bed_density, g, start.K0};
  solver.set(stress, [&](auto const& x) { return packed_stress(stress_there, x); });
  solver.template set<Wall>(slip_normal, wall, [&](auto const& x) {
    bool const beside = x[1] > 0;  // the floor carries shear
    return Vec<2, double>((beside ? (x[0] < width / 2 ? 1.0 : -1.0) : 0.0) * Vec<2, double>::UnitX());
  });
  return solver;
}

/// The column at one time. Stresses in rho g H, speeds in m/s.
struct Sample {
  double time = 0, rms = 0, floor = 0, speed = 0, largest_speed = 0, height = 0;
};

template <class S>
Sample sample_of(S const& solver) {
  using namespace fields;
  auto const x = solver.material().to_host(position);
  auto const u = solver.material().to_host(velocity);
  auto const sigma = solver.material().to_host(stress);
  Sample s{.time = solver.time()};
  double const all = double(x.size()), weight = bed_density * g;
  int in_lowest_row = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double const exact = -weight * (height - x[i][1]);
    s.rms += sq((sigma[i][1] - exact) / (weight * height)) / all;
    s.speed += u[i].squaredNorm() / all;
    s.largest_speed = std::max(s.largest_speed, u[i].norm());
    s.height += x[i][1] / all;
    if (x[i][1] > spacing) continue;
    s.floor += sigma[i][1] / exact;
    ++in_lowest_row;
  }
  s.rms = std::sqrt(s.rms), s.speed = std::sqrt(s.speed), s.floor /= in_lowest_row;
  return s;
}

/// 21 samples over a number of steps.
template <class S>
std::vector<Sample> watch(S& solver, long steps) {
  std::vector<Sample> samples;
  for (long n = 0; n <= steps; ++n) {
    if (n % (steps / 20) == 0) samples.push_back(sample_of(solver));
    if (n < steps) solver.step(1);
  }
  return samples;
}

/// Largest value of a quantity between two of the samples.
inline double most(std::vector<Sample> const& samples, double Sample::*figure, int from, int to) {
  double found = 0;
  for (int k = from; k <= to; ++k) found = std::max(found, samples[std::size_t(k)].*figure);
  return found;
}
/// Speed at which the centre of mass sinks over the second half, m/s.
inline double creep(std::vector<Sample> const& s) { return (s[10].height - s[20].height) / (s[20].time - s[10].time); }

/// The rules that a bed at rest breaks, by name; "" if there are none. `packing` is that at the end.
inline std::string faults(std::vector<Sample> const& s, Packing const& packing, bool filtered) {
  std::string found;
  auto const demand = [&](char const* name, bool holds) { found += holds ? "" : std::string(name) + " "; };
  demand("floor", std::abs(s[20].floor - 1) < 0.02);
  demand("rms", most(s, &Sample::rms, 10, 20) < 0.01);
  demand("creep", std::abs(creep(s)) < 0.01e-3);
  // Each application of a filter to all stress leaves a small imbalance, which leaves the bed as a wave.
  if (!filtered) demand("speed", most(s, &Sample::largest_speed, 16, 20) < 1e-5 * sound_speed);
  demand("growth", most(s, &Sample::speed, 16, 20) < 1.2 * most(s, &Sample::speed, 6, 10));
  demand("packing", is_packed_as_at_rest(packing));
  return found;
}

}  // namespace scree::test::column
