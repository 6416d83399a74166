// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "sand3d.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <map>
#include <numbers>

// A heap on a rough floor, from a source above its middle.
namespace scree::test::sand3d {
namespace {

double const dr = 2.5e-3, source = 0.015, above = 0.045, rate = 1.5e-4, duration = 1;  // m, m, m, m^3/s, s

Solver<Sand> heap(double mu_s) {
  double const radius = 0.1;
  auto const floor = kept(fill(Box<3>{{-radius, -radius, -4 * dr}, {radius, radius, 0}}, dr),
                          [&](X const& x) { return std::hypot(x[0], x[1]) < radius; });
  SolverSettings<Sand> settings{.spacing = dr, .lost_share = 1};
  settings.physics.law = beads(10);
  settings.physics.law.mu_s = mu_s;
  auto const start = fill(Box<3>{{-5 * dr, -5 * dr, 0}, {5 * dr, 5 * dr, 2 * dr}}, dr);
  Solver<Sand> solver(settings, start, floor);
  Inlet<3> inlet{.layer = kept(fill(Box<3>{{-source, -source, above}, {source, source, above + dr}}, dr),
                               [](X const& x) { return std::hypot(x[0], x[1]) < source; }),
                 .velocity = {0, 0, -0.5}};
  inlet.pushes = false, inlet.rate = rate, inlet.duration = duration;
  solver.feed(inlet);
  return solver;
}

/// The slope (degrees) of the surface between two shares of the radius of the heap.
double slope(Solver<Sand> const& solver, double from, double to) {
  std::map<std::pair<long, long>, double> top;  // of columns two spacings wide
  for (auto const& x : solver.material().to_host(position)) {
    auto& height = top[{std::lround(std::floor(x[0] / (2 * dr))), std::lround(std::floor(x[1] / (2 * dr)))}];
    height = std::max(height, double(x[2]));
  }
  double highest = 0, radius = 0;
  for (auto const& [cell, height] : top) highest = std::max(highest, height);
  std::vector<double> r, z;
  auto const distance = [](auto const& cell) {
    return 2 * dr * std::hypot(double(cell.first) + 0.5, double(cell.second) + 0.5);
  };
  for (auto const& [cell, height] : top)
    if (height > 3 * dr) radius = std::max(radius, distance(cell));
  for (auto const& [cell, height] : top)
    if (distance(cell) > from * radius && distance(cell) < to * radius)
      r.push_back(distance(cell)), z.push_back(height);
  UNSCOPED_INFO("height " << highest << " m, radius " << radius << " m, " << r.size() << " columns");
  return -std::atan(slope_of(r, z)) * 180 / std::numbers::pi;
}

}  // namespace

TEST_CASE("a heap has the slope of the friction that simple shear meets", "[.long]") {
  for (double const mu_s : {MuOfI<>().mu_s, 0.5}) {
    auto solver = heap(mu_s);
    double const expected = std::atan(friction_ratio(mu_s)) * 180 / std::numbers::pi;
    solver.run(duration);
    double const growing = slope(solver, 0.3, 0.8);
    for (int k = 1; k <= 3; ++k) {
      solver.run(duration + 0.25 * k);
      WARN("slope " << slope(solver, 0.3, 0.8) << " degrees after " << 0.25 * k << " s, growing " << growing
                    << ", expected " << expected);
    }
    CHECK(std::abs(slope(solver, 0.3, 0.8) - expected) < 1.5);
    auto const& entered = solver.entered()[0];
    CHECK(entered.particles + solver.particles_at_start() == solver.material().size());
    CHECK(std::abs(double(entered.particles) * dr * dr * dr - rate * duration) < 2 * rate * dr / 0.5);
  }
}

}  // namespace scree::test::sand3d
