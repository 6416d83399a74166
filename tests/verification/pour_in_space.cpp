// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "sand3d.hpp"

#include <scree/openings/inlet.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

// Sand rains into a closed box in space and makes a bed as deep as its volume, which rests. Figures:
// docs/theory/verification.md.
namespace scree::test::sand3d::pour_tests {
namespace {

double const width = 0.06, poured_depth = 0.04, inlet_height = 0.12, grain = 1e-3;  // m

struct Way {
  double speed;    ///< of the grains that enter, m/s
  int half_width;  ///< of the inlet, spacings
  double dr = 4e-3;
};
/// The bed 1.5 s after the last grain entered.
struct Bed {
  double depth = 0;     ///< twice the mean height, over the volume over the area
  double packing = 0;   ///< number density over that of the lattice in the lower half: median,
  double loose = 0;     ///< and 5 % quantile
  double pressure = 0;  ///< that one particle in a hundred exceeds, over that of the weight on the floor
  double speed = 0;     ///< the largest one, m/s
};

double quantile(std::vector<double> values, double share) {
  auto const place = values.begin() + long(share * double(values.size()));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

Bed poured(Way const& way) {
  using namespace fields;
  double const dr = way.dr, half = dr * way.half_width;
  double const pouring = poured_depth * sq(width) / (4 * sq(half) * way.speed);
  SolverSettings<Sand> settings{.spacing = dr};
  settings.physics.law = {.elastic = {.young = 3e5, .poisson = poisson, .rest_density = bed_density},
                          .grains = {.diameter = grain}};
  settings.physics.cfl = 0.4;
  Box<3> const inside{{-width / 2, -width / 2, 0}, {width / 2, width / 2, 0.2}};
  Solver<Sand> solver(settings, std::vector<X>{}, wall_around(inside, dr, 3));
  Box<3> const inlet{{-half, -half, inlet_height}, {half, half, inlet_height + dr}};
  solver.feed({.layer = fill_lattice(inlet, dr), .velocity = {0, 0, -way.speed}, .pushes = false, .duration = pouring});
  solver.run(pouring + 1.5);
  auto const x = solver.material().to_host(position), u = solver.material().to_host(velocity);
  auto const sigma = solver.material().to_host(stress);
  auto const phi = solver.material().to_host(number_density);
  double const count = double(x.size()), depth = count * math::power<3>(dr) / sq(width);
  Bed bed;
  std::vector<double> packing, pressure;
  for (std::size_t i = 0; i < x.size(); ++i) {
    bed.depth += 2 * x[i][2] / (count * depth);
    bed.speed = std::max(bed.speed, u[i].norm());
    pressure.push_back(-(sigma[i][0] + sigma[i][1] + sigma[i][2]) / (3 * bed_density * g * depth));
    if (x[i][2] < depth / 2) packing.push_back(phi[i] / solver.resolution().lattice_sum);
  }
  bed.packing = quantile(packing, 0.5), bed.loose = quantile(packing, 0.05), bed.pressure = quantile(pressure, 0.99);
  UNSCOPED_INFO("depth " << bed.depth << ", packing " << bed.packing << " (5 % " << bed.loose << "), pressure "
                         << bed.pressure << ", fastest " << bed.speed << " m/s");
  return bed;
}

}  // namespace

TEST_CASE("sand that rains in space makes a bed as deep and as dense as its volume, and rests", "[.long]") {
  for (Way const& way : {Way{0.3, 4}, Way{3, 7}, Way{0.3, 5, 3e-3}}) {
    Bed const bed = poured(way);
    CHECK(std::abs(bed.depth - 1) < 0.03);
    CHECK(std::abs(bed.packing - 1) < 0.03);
    CHECK(bed.loose > 0.95);
    CHECK(bed.pressure < 1.5);
    CHECK(bed.speed < 0.01);
  }
}

}  // namespace scree::test::sand3d::pour_tests
