// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "state.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

// A drum with a rough wall and a mixture of two sizes, before it settles.
namespace grains {

inline constexpr int large = 0, small = 1, glued = 2;  // kinds

/// The grains of cases EV and EN of Zhu, Peng & Wu (2024); lengths in m.
struct Filling {
  double drum_radius = 0.035;
  double length = 0.003;          ///< along the axis
  double fill_depth = 0.42;       ///< of the bed at the packing below, over the drum's diameter
  double packing = 0.6;           ///< of the solid: 1500 over 2500 kg/m^3
  double share_small = 0.5;       ///< of the solid's volume
  double large_radius = 0.25e-3;  ///< the small grains have half of it
  std::uint32_t seed = 1;
};

/// Area of a circle below a horizontal chord.
inline double segment_area(double radius, double depth) {
  double const to_chord = radius - depth;
  return radius * radius * std::acos(to_chord / radius) - to_chord * std::sqrt(radius * radius - to_chord * to_chord);
}

/// Random numbers that are the same with every standard library.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : engine_(seed) {}
  double uniform() { return engine_() / 4294967296.0; }
  std::size_t below(std::size_t n) { return std::min(n - 1, std::size_t(uniform() * double(n))); }

 private:
  std::mt19937 engine_;
};

/// Spheres of the size of the large grains that the wall consists of, each up to a fifth of its diameter further out at
/// random; the tips of the innermost ones are at the radius of the drum.
inline void add_rough_wall(std::vector<Grain>& grains, Filling const& f, int replica) {
  Dice dice(f.seed + 1000003);
  double const d = 2 * f.large_radius, around = f.drum_radius + f.large_radius;
  int const along = int(f.length / d + 1e-9);
  int const rows = 2 * int(std::numbers::pi * around / (d * std::sqrt(0.75)));
  for (int row = 0; row < rows; ++row) {
    for (int k = 0; k < along; ++k) {
      double const angle = 2 * std::numbers::pi * row / rows, y = (k + 0.5 * (row % 2)) * f.length / along;
      double const r = around + 0.2 * d * dice.uniform();
      grains.push_back({.x = {r * std::sin(angle), y, r * std::cos(angle)}, .kind = glued, .replica = replica});
    }
  }
}

/// Cubes that hold a large grain or eight small ones, at random; the lowest cubes in the drum are filled.
inline std::vector<Grain> fill(Filling const& f, int replica) {
  Dice dice(f.seed);
  double const d = 2 * f.large_radius;
  double const solid = f.packing * segment_area(f.drum_radius, f.fill_depth * 2 * f.drum_radius) * f.length;
  auto const wanted = std::size_t(solid / (std::numbers::pi / 6 * d * d * d) + 0.5);
  int const along = int(f.length / d + 1e-9);
  double const cube = 1.04 * d, half = cube / 2;
  int const across = int(f.drum_radius / cube) + 1;
  std::vector<std::array<double, 3>> cubes;
  for (int iz = -across; iz <= across && cubes.size() < wanted; ++iz) {
    for (int ix = -across; ix <= across && cubes.size() < wanted; ++ix) {
      double const x = cube * ix, z = cube * iz;
      if (std::hypot(std::abs(x) + half, std::abs(z) + half) > f.drum_radius) continue;
      for (int k = 0; k < along && cubes.size() < wanted; ++k) cubes.push_back({x, (k + 0.5) * f.length / along, z});
    }
  }
  if (cubes.size() < wanted) throw std::runtime_error("the filling does not fit into the drum before it settles");
  for (std::size_t k = cubes.size(); k > 1; --k) std::swap(cubes[k - 1], cubes[dice.below(k)]);
  auto const of_small = std::size_t(f.share_small * double(wanted) + 0.5);
  auto const push = [&](std::vector<Grain>& grains, std::array<double, 3> x, int kind) {
    auto const speed = [&] { return 0.02 * (dice.uniform() - 0.5); };
    grains.push_back({.x = x, .v = {speed(), speed(), speed()}, .kind = kind, .replica = replica});
  };
  std::vector<Grain> grains;
  double const q = f.large_radius / 2;
  for (std::size_t k = 0; k < cubes.size(); ++k) {
    auto const [x, y, z] = cubes[k];
    if (k >= of_small) {
      push(grains, {x, y, z}, large);
      continue;
    }
    for (int corner = 0; corner < 8; ++corner)
      push(grains, {x + (corner & 1 ? q : -q), y + (corner & 2 ? q : -q), z + (corner & 4 ? q : -q)}, small);
  }
  add_rough_wall(grains, f, replica);
  return grains;
}

}  // namespace grains
