// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "../setup/mesh/bodies.hpp"
#include "granular.hpp"

#include <scree/integrators/symplectic_euler.hpp>
#include <scree/motion/rotation_about.hpp>
#include <scree/setup/mesh.hpp>
#include <scree/setup/setup.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

// A short closed drum in space with its wall from an STL file against the same drum with a wall of rings.
namespace scree::test::drum::drum_in_space_tests {
namespace {

using X = Vec<3, double>;
struct Models : GranularModels {
  using law = VolumeMemory<MuOfI<>>;
  using volume_control = VolumeConsistency;
  using section = CircularCone;  // as in the drum of the paper
};
struct Turning : Formulation<3> {
  using physics = Granular<Models>;
  using motion = RotationAbout;
  using integrator = SymplecticEuler;
};

double const radius = 0.035, level = -0.0056, rate = 0.5236, dr = radius / 10, half = 5 * dr;  // m, m, rad/s, m, m

/// The inside of the drum in triangles, as an STL file has it.
Mesh vessel() {
  Triangles mesh;
  int const around = 360;
  for (int k = 0; k < around; ++k) {
    double const a = 2 * std::numbers::pi * k / around;
    for (double const y : {-half, half}) mesh.vertices.push_back({radius * std::cos(a), y, radius * std::sin(a)});
  }
  int const low = int(mesh.vertices.size());
  mesh.vertices.push_back({0, -half, 0}), mesh.vertices.push_back({0, half, 0});
  for (int k = 0; k < around; ++k) {
    int const a = 2 * k, b = 2 * ((k + 1) % around);
    for (std::array<int, 3> const& t :
         {std::array<int, 3>{a, a + 1, b}, {b, a + 1, b + 1}, {low, a, b}, {low + 1, b + 1, a + 1}})
      mesh.corners.push_back(t);
  }
  return Mesh(read_stl(ascii_stl(mesh), "drum.stl"));
}

struct Found {
  double angle = 0;      ///< degrees
  double farthest = -1;  ///< of a particle outside of the triangles, spacings
  long outside = 0;      ///< particles outside by more than half a spacing, of all samples
};

/// The steepest line through the highest particles of columns, in the middle half of the drum.
double angle_of(std::vector<X> const& x) {
  std::map<std::pair<long, long>, X> top;
  for (X const& p : x) {
    if (std::abs(p[0]) > 0.6 * radius || std::abs(p[1]) > half / 2) continue;
    auto const column = [&](int axis) { return std::lround(std::floor(p[axis] / (1.5 * dr))); };
    auto const [at, is_new] = top.try_emplace({column(0), column(1)}, p);
    if (!is_new && p[2] > at->second[2]) at->second = p;
  }
  double n = 0, sx = 0, sz = 0, sxx = 0, sxz = 0;
  for (auto const& [column, p] : top) n += 1, sx += p[0], sz += p[2], sxx += sq(p[0]), sxz += p[0] * p[2];
  return std::abs(std::atan((n * sxz - sx * sz) / (n * sxx - sx * sx))) * 180 / std::numbers::pi;
}

Found flow(Mesh const& body, std::vector<X> const& wall, double from, double until) {
  using namespace fields;
  Cylinder const inside{.axis = 1, .centre = {0, 0, 0}, .radius = radius, .from = -half, .to = half};
  auto const bed = fill_rings(inside, dr, HalfSpace<3>{.point = X(0, 0, level), .normal = X(0, 0, 1)});
  Granular<Models> physics;
  physics.law = {beads(5)};
  physics.viscosity_speed = 0.5, physics.cfl = 0.4, physics.volume_control.per_strain = 3;
  RotationAbout const motion(rate, {0, 1, 0});
  Solver<Turning> solver({.spacing = dr, .physics = physics, .motion = motion}, bed.points, wall);
  Geostatic const weight{.surface_height = level, .density = bed_density, .gravity = g, .K0 = 1};
  solver.set(volume, bed.volumes, [](double V) { return V; });
  solver.set(stress, [&](X const& x) { return packed_stress(weight, x); });
  solver.set(velocity, [&](X const& x) { return motion.velocity(x, 0); });
  Found found;
  int samples = 0;
  solver.run(until, {every<Solver<Turning>>(0.1, [&](Solver<Turning>& now) {
               auto const x = now.material().to_host(position);
               for (X const& p : x) {
                 double const beyond = body.signed_distance(motion.displaced(p, now.time(), 0.0)) / dr;
                 found.farthest = std::max(found.farthest, beyond), found.outside += beyond > 0.5;
               }
               if (now.time() >= from) found.angle += angle_of(x), ++samples;
             })});
  found.angle /= samples;
  found.outside += solver.lost();
  show_packing(solver);
  return found;
}

/// Runs both drums to a time (s), and compares their angles from another time on.
void compare(double from, double until) {
  Mesh const body = vessel();
  Cylinder const inside{.axis = 1, .centre = {0, 0, 0}, .radius = radius, .from = -half, .to = half};
  auto const rings = flow(body, wall_rings(inside, dr, 3, EndWalls::discs), from, until);
  auto const mesh = flow(body, wall_around(body, dr, 3), from, until);
  CAPTURE(rings.angle, mesh.angle, rings.farthest, mesh.farthest);
  CHECK(rings.outside + mesh.outside == 0);
  CHECK(std::abs(rings.angle - mesh.angle) < 1);
  CHECK((mesh.angle > 20 && mesh.angle < 28));
}

}  // namespace

TEST_CASE("a drum in space with its wall from an STL file holds its bed and flows as one with a wall of rings",
          "[.long]") {
  compare(2, 3);
}

}  // namespace scree::test::drum::drum_in_space_tests
