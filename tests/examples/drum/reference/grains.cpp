// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <drum/reference/bed.hpp>
#include <drum/reference/filling.hpp>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <cstring>
#include <utility>

namespace scree::test::drum_grains_tests {
using Catch::Approx;

namespace {

using Vec = std::array<double, 3>;
constexpr double r = 0.25e-3;  // of the large grains; the small ones have half of it

Vec plus(Vec const& a, Vec const& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vec times(double s, Vec const& a) { return {s * a[0], s * a[1], s * a[2]}; }
Vec cross(Vec const& a, Vec const& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double size(Vec const& a) { return std::hypot(a[0], a[1], a[2]); }

grains::Settings settings(double step) {
  return {.kinds = {{.radius = r}, {.radius = r / 2}, {.radius = r, .glued = true}},
          .material = {},
          .gravity = {0, 0, 0},
          .drum_radius = 4e-3,
          .length = 4e-3,
          .range = 4.5e-3,
          .step = step,
          .skin = 0.06e-3};
}

struct Pair {
  double speed = 0, duration = 0;
};
/// Relative speed after a head-on collision of two small grains, and how long their velocities changed.
Pair head_on(grains::Settings o) {
  o.check_every = 4;
  grains::Bed bed(o, {{.x = {-0.6 * r, 1e-3, 0}, .v = {0.05, 0, 0}, .kind = 1},
                      {.x = {0.6 * r, 1e-3, 0}, .v = {-0.05, 0, 0}, .kind = 1}});
  Pair result;
  double last = 0.05;
  for (int k = 0; k < 100000 && bed.time() < 4e-3; ++k) {
    bed.advance(1);
    double const now = bed.grains()[0].v[0];
    if (now != last) result.duration += o.step;
    last = now;
  }
  result.speed = std::abs(last) / 0.05;
  return result;
}

/// A heap of some 800 grains on the rough wall of a drum of 2.5 mm.
struct Heap {
  grains::Filling filling{.drum_radius = 2.5e-3, .length = 2.5e-3, .seed = 3};
  grains::Settings o = [] {
    auto s = settings(6.5e-6);
    s.gravity = {0, 0, -9.81}, s.drum_radius = 2.5e-3 + 2.4 * r, s.range = 3.7e-3, s.length = 2.5e-3;
    return s;
  }();
};

}  // namespace

TEST_CASE("two grains part after the time and with the speed of their coefficient of restitution") {
  for (double restitution : {0.5, 0.8, 1.0}) {
    auto o = settings(0);
    o.material.restitution = restitution;
    double const duration = grains::collision_time(o.material, r / 2);
    o.step = duration / 200;
    auto const fine = head_on(o);
    INFO("restitution " << restitution << ": " << fine.speed << " after " << fine.duration << " of " << duration);
    CHECK(fine.speed == Approx(restitution).margin(0.004));
    CHECK(fine.duration == Approx(duration).epsilon(0.015));
    o.step = duration / 20;  // of production runs
    CHECK(head_on(o).speed == Approx(restitution).margin(0.04));
  }
}

TEST_CASE("the period of an undamped collision is that of the spring") {
  grains::Material m{.modulus = 1e5, .restitution = 1};
  double const reduced = grains::mass(m, r / 2) / 2, k = 1e5 * r / 2;
  CHECK(grains::stiffness(m, r / 2, r / 2) == Approx(k));
  CHECK(grains::collision_time(m, r / 2) == Approx(std::numbers::pi * std::sqrt(reduced / k)).epsilon(1e-6));
}

TEST_CASE("a grain that slides along the drum ends up rolling at 5/7 of its speed") {
  auto o = settings(2e-6);
  o.gravity = {0, 0, -9.81};
  double const m = grains::mass(o.material, r), sunk = m * 9.81 / (2 * o.material.modulus * r), v = 0.05;
  grains::Bed bed(o, {{.x = {0, 1e-3, -o.drum_radius + r - sunk}, .v = {0, v, 0}, .kind = 0}});
  double const stop = 2 * v / (7 * o.material.friction * 9.81);
  long const half = std::lround(stop / 2 / o.step);
  bed.advance(half);
  auto const sliding = bed.grains()[0];
  double const lost = o.material.friction * 9.81 * bed.time();
  CHECK(sliding.v[1] == Approx(v - lost).epsilon(0.004));
  CHECK(sliding.spin[0] * r == Approx(-2.5 * lost).epsilon(0.01));
  bed.advance(4 * half);
  auto const rolling = bed.grains()[0];
  CHECK(rolling.v[1] == Approx(5.0 / 7 * v).epsilon(1e-3));
  CHECK(rolling.spin[0] * r == Approx(-rolling.v[1]).epsilon(1e-3));
  CHECK(std::abs(rolling.x[0]) < 1e-9);
}

TEST_CASE("grains that collide keep their momentum and angular momentum, and lose energy") {
  auto o = settings(2e-6);
  std::vector<grains::Grain> const start = {
      {.x = {0, 1e-3, 0}, .v = {0.05, 0.01, -0.02}, .spin = {20, -50, 30}, .kind = 0},
      {.x = {1.45 * r, 1e-3 + 0.3 * r, 0.4 * r}, .v = {-0.1, 0.02, 0.01}, .spin = {-100, 40, 200}, .kind = 1}};
  grains::Bed bed(o, start);
  auto const sums = [&](std::vector<grains::Grain> const& all) {
    Vec momentum{}, turning{};
    double energy = 0;
    for (auto const& g : all) {
      double const radius = o.kinds[g.kind].radius, m = grains::mass(o.material, radius),
                   inertia = 0.4 * m * radius * radius;
      momentum = plus(momentum, times(m, g.v));
      turning = plus(turning, plus(times(m, cross(g.x, g.v)), times(inertia, g.spin)));
      energy += m * std::pow(size(g.v), 2) / 2 + inertia * std::pow(size(g.spin), 2) / 2;
    }
    return std::tuple{momentum, turning, energy};
  };
  auto const [p0, l0, e0] = sums(start);
  bed.advance(500);
  auto const [p1, l1, e1] = sums(bed.grains());
  REQUIRE(std::abs(bed.grains()[1].v[0] + 0.1) > 0.02);  // they met
  CHECK(size(plus(p1, times(-1, p0))) < 2e-6 * size(p0));
  CHECK(size(plus(l1, times(-1, l0))) < 1e-5 * size(l0));
  CHECK(e1 < 0.99 * e0);
  CHECK(e1 > 0.2 * e0);
}

TEST_CASE("grains meet across the end of the period") {
  auto o = settings(2e-6);
  grains::Bed bed(o, {{.x = {0, 0.3 * r, 0}, .v = {0, -0.05, 0}, .kind = 1},
                      {.x = {0, o.length - 0.9 * r, 0}, .v = {0, 0.05, 0}, .kind = 1}});
  bed.advance(1000);
  CHECK(bed.grains()[0].v[1] == Approx(0.8 * 0.05).epsilon(0.01));
  CHECK(bed.grains()[1].v[1] == Approx(-0.8 * 0.05).epsilon(0.01));
}

TEST_CASE("a bed of grains has the contacts that all pairs of its grains have, and the same bits again") {
  Heap heap;
  // The second bed has three cells along its axis, the least; its reach over their size is rounded above 1 in float.
  auto const [length, skin] = GENERATE(std::pair(2.5e-3, 60e-6), std::pair(2e-3, 64e-6));
  heap.filling.length = heap.o.length = length, heap.o.skin = skin;
  auto const run = [&] {
    grains::Bed bed(heap.o, grains::fill(heap.filling, 0));
    bed.set_rotation(5);
    bed.advance(3000);
    return bed;
  };
  auto const bed = run();
  CHECK(bed.rebuilds() > 10);
  auto const all = bed.grains();
  long contacts = 0;
  double closest = 0;
  for (auto const& a : all) {
    if (heap.o.kinds[a.kind].glued) continue;
    for (auto const& b : all) {
      double dy = a.x[1] - b.x[1];
      dy -= heap.o.length * std::round(dy / heap.o.length);
      double const reach = heap.o.kinds[a.kind].radius + heap.o.kinds[b.kind].radius;
      double const overlap = reach - size({a.x[0] - b.x[0], dy, a.x[2] - b.x[2]});
      if (&a == &b || overlap <= 0) continue;
      ++contacts;
      closest = std::max(closest, overlap / (2 * std::min(heap.o.kinds[a.kind].radius, heap.o.kinds[b.kind].radius)));
    }
  }
  auto const found = bed.overlaps();
  CHECK(contacts > bed.mobile());
  CHECK(std::lround(found.contacts * bed.mobile()) ==
        Approx(contacts).margin(2));  // at a gap of zero floats may differ
  CHECK(found.largest == Approx(closest).epsilon(1e-3));
  auto const again = run().grains();
  REQUIRE(all.size() == again.size());
  CHECK(std::memcmp(all.data(), again.data(), all.size() * sizeof(all[0])) == 0);
}

TEST_CASE("a heap of grains on a slope stays where it is") {
  Heap const heap;
  grains::Bed bed(heap.o, grains::fill(heap.filling, 0));
  bed.advance(6000);
  bed.set_rotation(4);  // by 12 degrees, below the angle of repose
  bed.advance(8000);
  bed.set_rotation(0);
  bed.advance(5000);
  auto const before = bed.grains();
  double x = 0, mass = 0;
  for (auto const& g : before) {
    if (heap.o.kinds[g.kind].glued) continue;
    double const m = grains::mass(heap.o.material, heap.o.kinds[g.kind].radius);
    x += m * g.x[0], mass += m;
  }
  CHECK(x / mass < -0.1 * heap.filling.drum_radius);  // the bed went up on the left
  bed.advance(6000);
  auto const after = bed.grains();
  long moved = 0;
  for (std::size_t k = 0; k < before.size(); ++k) moved += size(plus(after[k].x, times(-1, before[k].x))) > 0.02 * r;
  CHECK(bed.kinetic_energy() / mass < 1e-8);
  CHECK(moved < 0.02 * double(before.size()));
  CHECK(bed.late_rebuilds() == 0);
}

TEST_CASE("fillings have the volumes of EV and EN, and a wall that the grains cannot pass") {
  for (auto const& [depth, share] : {std::pair{0.42, 0.5}, std::pair{0.591, 1.0 / 9}}) {
    grains::Filling const f{.drum_radius = 8e-3, .fill_depth = depth, .share_small = share};
    auto const all = grains::fill(f, 0);
    double of_small = 0, solid = 0;
    for (auto const& g : all) {
      if (g.kind == grains::glued) {
        CHECK(std::hypot(g.x[0], g.x[2]) >= f.drum_radius + r - 1e-12);
        continue;
      }
      double const volume = grains::mass({.density = 1}, g.kind == grains::small ? r / 2 : r);
      solid += volume, of_small += g.kind == grains::small ? volume : 0;
      CHECK(std::hypot(g.x[0], g.x[2]) < f.drum_radius);
    }
    double const expected = 0.6 * grains::segment_area(f.drum_radius, depth * 2 * f.drum_radius) * f.length;
    CHECK(solid == Approx(expected).epsilon(1e-3));
    CHECK(of_small / solid == Approx(share).margin(1e-3));
  }
  CHECK(grains::segment_area(1, 1) == Approx(std::numbers::pi / 2));
  CHECK_THROWS(grains::fill({.fill_depth = 0.99}, 0));
}

TEST_CASE("beds of grains refuse what they cannot represent") {
  auto o = settings(2e-6);
  CHECK_THROWS(grains::Bed(o, {{.x = {5e-3, 0, 0}}}));
  CHECK_THROWS(grains::Bed(o, {{.kind = 3}}));
  CHECK_THROWS(grains::Bed(o, {{.replica = 1}}));
  o.length = 1e-3;
  CHECK_THROWS(grains::Bed(o, {}));
  CHECK_THROWS(grains::damping_ratio(0));
  CHECK_THROWS(grains::damping_ratio(1.1));
}

}  // namespace scree::test::drum_grains_tests
