// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "granular.hpp"

#include <scree/integrators/symplectic_euler.hpp>
#include <scree/openings/inlet.hpp>
#include <scree/setup/setup.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

// Sand is poured onto a floor in the plane. The heap has the slope of the friction at rest and the density of the
// material, and keeps both when the inlet is closed. Figures: docs/theory/verification.md.
namespace scree::test::heap_in_plane_tests {
namespace {

using X = Vec<2, double>;
double const dr = 3e-3, half_base = 0.1, sound_speed = 10, pouring = 3;  // m, m, m/s, s

struct Poured : Formulation<2> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Granular<>;
  using integrator = SymplecticEuler;
};
struct Heap {
  double slope = 0, packing = 0, fastest = 0;  ///< degrees, number density over that of the lattice (median), m/s
};

/// From a quarter to three quarters of the half base; the heap is twice as high as its particles are in the mean.
Heap heap_of(Solver<Poured> const& solver, double steepness) {
  using namespace fields;
  auto const x = solver.material().to_host(position), u = solver.material().to_host(velocity);
  auto const phi = solver.material().to_host(number_density);
  double n = 0, a = 0, b = 0, aa = 0, ab = 0;
  std::vector<double> inside;
  Heap heap;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double const r = std::abs(x[i][0]), height = 2 * x[i][1];
    heap.fastest = std::max(heap.fastest, u[i].norm());
    if (r > half_base / 4 && r < 3 * half_base / 4) n += 1, a += r, b += height, aa += r * r, ab += r * height;
    if (x[i][1] < 0.9 * steepness * (half_base - r) - 2 * dr) inside.push_back(phi[i]);
  }
  heap.slope = -std::atan((n * ab - a * b) / (n * aa - a * a)) * 180 / std::numbers::pi;
  std::sort(inside.begin(), inside.end());
  if (!inside.empty()) heap.packing = inside[inside.size() / 2] / solver.resolution().lattice_sum;
  UNSCOPED_INFO("t " << solver.time() << " s: slope " << heap.slope << ", packing " << heap.packing << ", fastest "
                     << heap.fastest << " m/s");
  return heap;
}

struct Pair {
  Heap early, late;  ///< 0.5 s after the inlet is closed, and at the end
};
/// The inlet is `lift` (m) higher than 4 spacings above the heap.
Pair poured(double friction, double at_rest, double lift) {
  MuOfI<> sand = beads(sound_speed, 1e-3);
  sand.mu_d += friction - sand.mu_s, sand.mu_s = friction;
  double const steepness = friction_ratio(friction), height = half_base * steepness, area = half_base * height;
  double const half = std::ceil(1.6 * half_base / dr) * dr, drop = height + 4 * dr + lift, source = 0.15 * half_base;
  Granular<> physics;
  physics.law = sand;
  physics.cfl = 0.4;
  Box<2> const inside{{-half, 0}, {half, 5 * dr}}, outer{{-half - 3 * dr, -3 * dr}, {half + 3 * dr, 5 * dr}};
  Solver<Poured> solver({.spacing = dr, .physics = physics}, std::vector<X>{}, fill_between(inside, outer, dr));
  auto layer = fill_lattice(Box<2>{{-half, drop}, {half, drop + dr}}, dr);
  std::erase_if(layer, [&](X const& x) { return !(std::abs(x[0]) < source); });
  double const speed = 1.5 * area / (pouring * double(layer.size()) * dr);
  solver.feed(
      Inlet<2>{.layer = layer, .velocity = {0, -speed}, .pushes = false, .rate = area / pouring, .duration = pouring});
  solver.run(pouring + 0.5);
  Heap const early = heap_of(solver, steepness);
  solver.run(pouring + at_rest);
  return {early, heap_of(solver, steepness)};
}

/// Where the last avalanche of a heap stops is chance: a slope is the mean of several heaps.
void check_heaps(double friction, double at_rest, int heaps) {
  double const exact = std::atan(friction_ratio(friction)) * 180 / std::numbers::pi;
  UNSCOPED_INFO("friction " << friction << ", exact slope " << exact << " degrees");
  double early = 0, late = 0;
  for (int k = 0; k < heaps; ++k) {
    Pair const heap = poured(friction, at_rest, k * dr);
    early += heap.early.slope / heaps, late += heap.late.slope / heaps;
    CHECK(std::abs(heap.late.slope - exact) < 3);
    CHECK(std::abs(heap.late.slope - heap.early.slope) < 1.5);
    CHECK(std::abs(heap.late.packing - 1) < 0.05);
    CHECK(heap.late.fastest < 5e-3);
  }
  INFO("mean slope " << early << ", at the end " << late);
  CHECK(std::abs(early - exact) < 1.5);
  CHECK(std::abs(late - exact) < 1.5);
}

}  // namespace

TEST_CASE("a heap in the plane is as steep as its friction allows and as dense as the material") {
  check_heaps(0.6, 1.5, 4);
}
TEST_CASE("heaps in the plane keep slope and density for five seconds", "[.long]") {
  for (double const friction : {0.25, 0.382, 0.6}) check_heaps(friction, 5, 5);
}

}  // namespace scree::test::heap_in_plane_tests
