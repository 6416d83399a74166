// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "granular.hpp"

#include <scree/boundaries/conserving.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/setup/setup.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

// A bed of stiff sand slides along a smooth floor, whose particles it passes one after the other. Nothing slows it
// down, and nothing in it may depend on how fast it slides.
namespace scree::test::sliding_tests {
namespace {

template <class Scheme>
struct Models : GranularModels {
  using walls = Scheme;
};
struct Slid {
  double speed = 0;             // mean along the floor over that at the start
  double rms = 0;               // of all other motion, m/s
  std::vector<double> on_rows;  // mean pressure across the floor in the lowest two rows, Pa, at five times
};
template <class Real, class Scheme>
Slid slide(double speed, double young, double duration) {
  using namespace fields;
  using P = GranularCase<2, Granular<Models<Scheme>>, Real, SymplecticEuler>;
  double const dr = 0.01, length = 0.2, depth = 0.1;
  SolverSettings<P> settings{.spacing = dr, .periods = {{0, 0, length}}};
  settings.physics.law = {.elastic = {.young = young, .poisson = 0.3, .rest_density = bed_density}, .grains = {1e-3}};
  Solver<P> solver(settings, cast<Real>(fill_lattice(Box<2>{{0, 0}, {length, depth}}, dr)),
                   cast<Real>(fill_lattice(Box<2>{{0, -3 * dr}, {length, 0}}, dr)));
  Geostatic const bed{depth, bed_density, g, 0.5};
  solver.set(stress, [&](auto const& x) { return packed_stress<2>(bed, Vec<2, Real>(x)); });
  solver.set(velocity, [&](auto const&) { return Vec<2, Real>(Real(speed), 0); });
  solver.template set<Wall>(slip_normal, [](auto const&) { return Vec<2, Real>(0, 1); });
  Slid slid;
  for (int k = 1; k <= 5; ++k) {
    solver.run(duration * k / 5);
    auto const u = solver.material().to_host(velocity), x = solver.material().to_host(position);
    auto const sigma = solver.material().to_host(stress);
    double mean = 0, square = 0, pressure = 0, count = 0;
    for (auto const& each : u) mean += double(each[0]) / double(u.size());
    for (std::size_t i = 0; i < u.size(); ++i) {
      square += sq(u[i][0] - mean) + sq(u[i][1]);
      if (x[i][1] < 2 * dr) pressure -= sigma[i][1], count += 1;
    }
    slid.speed = mean / speed;
    slid.rms = std::sqrt(square / double(u.size()));
    slid.on_rows.push_back(pressure / count);
  }
  return slid;
}

}  // namespace

TEST_CASE("a bed slides along a smooth floor that conserves as if it were at rest, however stiff and fast") {
  double const weight = bed_density * g * 0.09;  // above the middle of the lowest two rows
  for (double const young : {3e5, 3e7}) {
    Slid const slow = slide<double, ConservingWalls>(0.05, young, 0.1);
    for (double const speed : {0.3, 3.0}) {
      Slid const fast = slide<double, ConservingWalls>(speed, young, 0.1);
      INFO("E " << young << " Pa, " << speed << " m/s: speed " << fast.speed - 1 << ", rms " << fast.rms << " of "
                << slow.rms << " m/s");
      CHECK(std::abs(fast.speed - 1) * speed < 1e-6);  // by the viscosity between bed and floor
      CHECK(std::abs(fast.rms / slow.rms - 1) < 0.05);
      for (std::size_t k = 0; k < fast.on_rows.size(); ++k)
        CHECK(std::abs(fast.on_rows[k] - slow.on_rows[k]) < 0.01 * weight);
    }
  }
}
// Slower than `sliding_speed` it feels the lattice of the floor.
TEST_CASE("a smooth floor that conserves holds slow material by at most 0.15 % of its weight") {
  for (double const young : {3e5, 3e7})
    for (double const speed : {0.001, 0.005, 0.0075}) {
      double const duration = 0.2, held = 1 - slide<double, ConservingWalls>(speed, young, duration).speed;
      INFO("E " << young << " Pa, " << speed << " m/s: " << held);
      CHECK(std::abs(held) * speed / (g * duration) < 1.5e-3);
    }
}
TEST_CASE("in single precision a bed slides along a smooth floor as in double precision") {
  Slid const single = slide<float, ConservingWalls>(1, 3e6, 0.1), twice = slide<double, ConservingWalls>(1, 3e6, 0.1);
  CAPTURE(single.speed - 1, single.rms, twice.rms);
  CHECK(std::abs(single.speed - 1) < 1e-5);
  for (std::size_t k = 0; k < single.on_rows.size(); ++k)
    CHECK(std::abs(single.on_rows[k] / twice.on_rows[k] - 1) < 0.01);
}

}  // namespace scree::test::sliding_tests
