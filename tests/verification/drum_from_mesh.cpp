// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "turning_drum.hpp"

#include <scree/setup/mesh.hpp>
#include <scree/setup/walls.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

// The rotating drum with its wall from the section of a mesh against the same drum with a wall of rings.
namespace scree::test::drum::drum_from_mesh_tests {
namespace {

using X = Vec<2, double>;
struct Models : GranularModels {
  using law = VolumeMemory<MuOfI<>>;
  using volume_control = VolumeConsistency;
};
using Mechanics = Granular<Models>;
using P = Walled<Mechanics, Rotation>;

/// A closed cylinder about the y axis as an OBJ file has it.
Mesh cylinder(double r, double half, int around) {
  Triangles mesh;
  for (int k = 0; k < around; ++k) {
    double const a = 2 * std::numbers::pi * k / around;
    for (double const y : {-half, half}) mesh.vertices.push_back({r * std::cos(a), y, r * std::sin(a)});
  }
  int const low = int(mesh.vertices.size());
  mesh.vertices.push_back({0, -half, 0}), mesh.vertices.push_back({0, half, 0});
  for (int k = 0; k < around; ++k) {
    int const a = 2 * k, b = 2 * ((k + 1) % around);
    for (std::array<int, 3> const& t :
         {std::array<int, 3>{a, a + 1, b}, {b, a + 1, b + 1}, {low, a, b}, {low + 1, b + 1, a + 1}})
      mesh.corners.push_back(t);
  }
  return Mesh(mesh);
}

struct Found {
  double angle = 0, speed = 0, density = 0;  ///< degrees, m/s, -
  long outside = 0;
};

Found flow(std::vector<X> const& wall, double dr, double from, double until) {
  using namespace fields;
  Numbers const numbers{.spacing = dr};
  auto const physics = mechanics<Mechanics>(numbers);
  Ball<2> const inside{.centre = {0, 0}, .radius = radius};
  auto const bed = fill_rings(inside, dr, HalfSpace<2>{.point = X(0, level), .normal = X(0, 1)});
  Rotation const motion{.rate = -rate};
  Solver<P> solver({.spacing = dr, .physics = physics, .motion = motion}, bed.points, wall);
  Geostatic const weight{.surface_height = level, .density = bed_density, .gravity = g, .K0 = 1};
  solver.set(volume, bed.volumes, [](double V) { return V; });
  solver.set(stress, [&](X const& x) { return packed_stress(weight, x); });
  solver.set(velocity, [&](X const& x) { return motion.velocity(x, 0); });
  Found f;
  int samples = 0;
  solver.run(until, {every<Solver<P>>(0.05, [&](Solver<P>& now) {
               if (now.time() < from) return;
               now.update_rates();
               auto const x = now.material().to_host(position), u = now.material().to_host(velocity);
               auto const phi = now.material().to_host(number_density);
               std::map<long, std::size_t> top;  // of each column
               for (std::size_t i = 0; i < x.size(); ++i) {
                 if (std::abs(x[i][0]) > 0.6 * radius) continue;
                 auto const [at, is_new] = top.try_emplace(std::lround(std::floor(x[i][0] / (1.5 * dr))), i);
                 if (!is_new && x[i][1] > x[at->second][1]) at->second = i;
               }
               double n = 0, sx = 0, sz = 0, sxx = 0, sxz = 0, speed = 0, middle = 0;
               for (auto const& [column, i] : top) {
                 n += 1, sx += x[i][0], sz += x[i][1], sxx += sq(x[i][0]), sxz += x[i][0] * x[i][1];
                 if (std::abs(x[i][0]) < 0.3 * radius) speed += u[i].norm(), middle += 1;
               }
               double const slope = (n * sxz - sx * sz) / (n * sxx - sx * sx), height = (sz - slope * sx) / n;
               double density = 0, deep = 0;
               for (std::size_t i = 0; i < x.size(); ++i) {
                 bool const inner = height + slope * x[i][0] - x[i][1] > 4 * dr && x[i].norm() < radius - 0.6 * dr;
                 if (inner) density += phi[i] / now.resolution().lattice_sum, deep += 1;
                 f.outside += x[i].norm() > radius + dr / 2;  // the first wall particles are up to a spacing off it
               }
               f.angle += std::abs(std::atan(slope)) * 180 / std::numbers::pi, f.speed += speed / middle;
               f.density += density / deep;
               ++samples;
             })});
  f.angle /= samples, f.speed /= samples, f.density /= samples;
  show_packing(solver);
  return f;
}

/// How far the flow between walls around the section of a mesh is from that between rings.
void compare(double dr, double from, double until) {
  Ball<2> const disc{.centre = {0, 0}, .radius = radius};
  auto const inside = section(cylinder(radius, 10 * dr, 360), 0);
  auto const a = flow(wall_rings(disc, dr, 3), dr, from, until), b = flow(wall_around(inside, dr, 3), dr, from, until);
  CAPTURE(dr, a.angle, b.angle, a.speed, b.speed, a.density, b.density);
  CHECK(std::abs(a.angle - b.angle) < 0.3);
  CHECK(std::abs(b.speed / a.speed - 1) < 0.03);
  CHECK(std::abs(b.density / a.density - 1) < 0.005);
  CHECK(a.outside + b.outside == 0);
}

}  // namespace

TEST_CASE("a drum with its wall from a mesh flows as one with a wall of rings") { compare(radius / 14, 4, 9); }
TEST_CASE("finer drums with their walls from a mesh flow as those with walls of rings", "[.long]") {
  compare(radius / 20, 4, 9);
  compare(radius / 28, 6, 12);
}
TEST_CASE("no particle passes through the wall of a drum from a mesh in 40 s", "[.long]") {
  compare(radius / 14, 4, 40);
}
// A wall that is not where that of the mesh should be.
TEST_CASE("a drum that is three spacings wider than the other has another surface speed") {
  double const dr = radius / 14;
  auto const wall = [](double r, double spacing) { return wall_around(Ball<2>{{0, 0}, r}, spacing, 3); };
  auto const a = flow(wall(radius, dr), dr, 4, 7), b = flow(wall(radius + 3 * dr, dr), dr, 4, 7);
  CAPTURE(a.angle, b.angle, a.speed, b.speed, a.density, b.density);
  CHECK((std::abs(a.angle - b.angle) > 0.3 || std::abs(b.speed / a.speed - 1) > 0.03));
}

}  // namespace scree::test::drum::drum_from_mesh_tests
