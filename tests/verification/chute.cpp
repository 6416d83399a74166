// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "sand3d.hpp"

#include <scree/setup/terrain.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>

// Sand runs down a chute onto a plane. The ground is made of two planes, or read from a raster of its heights.
namespace scree::test::sand3d::chute_tests {
namespace {

double const dr = 6e-3, steep = degrees(35), across = 8 * dr, top = 0.25;  // m, rad, m, m
double const start = -0.12;                                                // of the front, m
double height(double x) { return std::max(0.0, -x * std::tan(steep)); }

/// The front (m) at moments.
template <class Ground>
std::vector<double> fronts(Ground const& ground) {
  Box<3> const within{{-top / std::tan(steep) - 0.1, 0, -4 * dr}, {0.8, across, top + 0.1}};
  auto const wall = wall_around(complement(ground), dr, 4, within);
  auto const block = kept(fill_lattice(within, dr), [&](X const& x) {
    double const d = ground.signed_distance(x);
    return d > 0 && d < 10 * dr && x[0] > -0.32 && x[0] < start;
  });
  SolverSettings<Sand> settings{.spacing = dr, .periods = {{1, 0, across}}, .lost_share = 1};
  settings.physics.law = beads(20);
  Solver<Sand> solver(settings, block, wall);
  std::vector<double> result;
  for (double const moment : {0.1, 0.2, 0.3, 0.4, 0.6}) {
    solver.run(moment);
    std::vector<double> ahead;
    for (auto const& x : solver.material().to_host(fields::position)) ahead.push_back(x[0]);
    // Grains that run ahead of the front do not feel the ground.
    auto const last = ahead.begin() + long(double(ahead.size()) * 0.9);
    std::nth_element(ahead.begin(), last, ahead.end());
    result.push_back(*last);
  }
  show_packing(solver);
  return result;
}
/// Heights every 3 spacings; the bend is between two of them where `off` is not zero.
HeightField from_raster(double off) {
  Raster raster{.name = "chute", .columns = 120, .rows = 6, .spacing = 3 * dr};
  raster.x = -40 * raster.spacing + off * raster.spacing, raster.y = -raster.spacing;
  for (int j = 0; j < raster.rows; ++j)
    for (int i = 0; i < raster.columns; ++i) raster.values.push_back(height(raster.x_of(i)));
  return HeightField(raster);
}

}  // namespace

TEST_CASE("sand runs as far on a chute from a raster as on one of planes", "[.long]") {
  HalfSpace<3> const chute{{0, 0, 0}, {std::sin(steep), 0, std::cos(steep)}}, plane{{0, 0, 0}, {0, 0, 1}};
  auto const exact = fronts(chute | plane);
  for (double const off : {0.0, 0.5}) {
    auto const found = fronts(from_raster(off));
    for (std::size_t k = 0; k < exact.size(); ++k) {
      double const deviation = (found[k] - exact[k]) / (exact[k] - start);
      WARN("off " << off << ": front at " << exact[k] << " m, from the raster " << 100 * deviation << " % farther");
      // The walls differ by a row of particles at the bend.
      CHECK(std::abs(found[k] - exact[k]) < std::max(0.02 * (exact[k] - start), dr));
      CHECK(exact[k] < 0.7);  // on the plane
    }
  }
}

}  // namespace scree::test::sand3d::chute_tests
