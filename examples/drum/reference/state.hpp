// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "contact.hpp"

#include <Kokkos_Core.hpp>

#include <array>
#include <cstdint>
#include <vector>

// Spheres in a drum that turns about the y axis and is periodic along it, and what is known of each.
namespace grains {

using Space = Kokkos::DefaultExecutionSpace;
template <class T>
using Column = Kokkos::View<T*, Space>;
template <class T>
using Table = Kokkos::View<T**, Kokkos::LayoutLeft, Space>;  // grain, slot

/// Place of a grain in units of Units, so that differences are exact; y wraps around.
struct alignas(16) Place {
  std::int32_t x = 0, y = 0, z = 0;
  float radius = 0;
};

/// A grain as it is given to a bed and taken from it, SI units.
struct Grain {
  std::array<double, 3> x = {}, v = {}, spin = {};  ///< spin: angular velocity
  int kind = 0;                                     ///< entry of Settings::kinds
  int replica = 0;                                  ///< grains of different replicas do not touch
};

/// Grains of one size; the glued ones turn with the drum.
struct Kind {
  double radius = 0;
  bool glued = false;
};

struct Settings {
  std::vector<Kind> kinds = {};  ///< at most four; the glued ones last
  Material material = {};
  std::array<double, 3> gravity = {0, 0, -9.81};
  double drum_radius = 0;  ///< of the smooth cylinder, m; must be less than `range`
  double length = 0;       ///< period along y, m
  double range = 0;        ///< x and z are in [-range, range]
  double rotation = 0;     ///< angular velocity of the drum about +y
  double step = 0;         ///< s
  double skin = 0;         ///< lists hold neighbours within a gap of this, m
  int replicas = 1;
  int check_every = 8;  ///< steps between checks whether the lists must be renewed
};

inline constexpr int max_kinds = 4, max_slots = 63;
inline constexpr std::uint64_t wall_bit = std::uint64_t(1) << 63;  ///< of State::touching

struct Units {
  float xz = 0, y = 0;  ///< m
};

/// a - b in m.
KOKKOS_INLINE_FUNCTION Vector difference(Place const& a, Place const& b, Units const& u) {
  auto const minus = [](std::int32_t c, std::int32_t d) {
    return float(std::int32_t(std::uint32_t(c) - std::uint32_t(d)));
  };
  return {u.xz * minus(a.x, b.x), u.y * minus(a.y, b.y), u.xz * minus(a.z, b.z)};
}
KOKKOS_INLINE_FUNCTION std::int32_t moved(std::int32_t from, float by) {
  return std::int32_t(std::uint32_t(from) + std::uint32_t(std::int32_t(Kokkos::round(by))));
}

/// The grains of a bed, sorted by kind, replica and cell.
struct State {
  Column<Place> place;
  Column<Vector> velocity, spin;  // spin: angular velocity times radius
  Column<std::uint8_t> replica;
  Column<int> identity;             // number in the list that the bed was made from
  Column<double> start_x, start_z;  // of glued grains, at angle 0
  Column<std::uint64_t> touching;   // bit of each slot whose spring counts, and wall_bit
  Column<int> count;                // neighbours
  Table<int> neighbour;
  Table<Vector> spring;
  Column<Vector> wall_spring;  // of the contact with the cylinder

  State() = default;
  explicit State(int n)
      : place("place", n),
        velocity("velocity", n),
        spin("spin", n),
        replica("replica", n),
        identity("identity", n),
        start_x("start_x", n),
        start_z("start_z", n),
        touching("touching", n),
        count("count", n),
        neighbour("neighbour", n, max_slots),
        spring("spring", n, max_slots),
        wall_spring("wall_spring", n) {}
};

}  // namespace grains
