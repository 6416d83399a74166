// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "grain_equilibrium.hpp"
#include "inclined.hpp"

#include <scree/granular/segregating.hpp>
#include <scree/segregation/conservative.hpp>
#include <scree/segregation/shear_rate_closure.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

// Grains of two sizes in a layer that flows down a slope: shear rate, friction and concentration found together. The
// steady concentration does not depend on the shear rate. Figures: docs/theory/verification.md.
namespace scree::test::inclined::segregating_flow_tests {
namespace {

struct Models : GranularModels {
  using law = VolumeMemory<MuOfI<BidisperseGrains>>;
  using volume_control = VolumeConsistency;
};
using Mechanics = Granular<Models>;
using Sorting = SegregatingGranular<Mechanics, ConservativeSegregation<ShearRateClosure>>;

/// An even mixture in Bagnold flow of its mean diameter. Grains change places `faster` times as fast as usual.
Solver<GranularCase<2, Sorting>> mixture(Slope const& slope, double mean, double faster) {
  using namespace fields;
  Bagnold const flow = exact(slope);
  double const dr = depth / slope.rows, length = 10 * dr, small = 2.0 / 3 * grain, large = 4.0 / 3 * grain;
  Sorting physics;
  physics.mechanics.law = {{.elastic = flow.law.elastic, .grains = {small, large}}};
  physics.mechanics.gravity = {g, flow.angle};
  physics.mechanics.viscosity_speed = slope.viscosity_speed;
  physics.mechanics.cfl = 0.3;
  physics.transport.closure = {.chi_V = 0.11 * faster, .chi_D = 0.0307 * faster, .d_small = small, .d_large = large};
  Solver<GranularCase<2, Sorting>> solver({.spacing = dr, .physics = physics, .periods = {{0, 0, length}}},
                                          fill_lattice(Box<2>{{0, 0}, {length, depth}}, dr),
                                          fill_lattice(Box<2>{{0, -4 * dr}, {length, 0}}, dr));
  solver.set(stress, [&](auto const& x) {
    double const p = flow.pressure(x[1]);
    return Vec<4, double>(-p, -p, -p, std::tan(flow.angle) * p);
  });
  solver.set(velocity, [&](auto const& x) { return Vec<2, double>(flow.velocity(x[1]), 0); });
  solver.set(concentration, [&](auto const&) { return mean; });
  return solver;
}

/// Twice the mean height, m: the layer settles by about 0.3 % of its depth.
double depth_of(std::vector<Vec<2, double>> const& x) {
  double sum = 0;
  for (auto const& each : x) sum += each[1];
  return 2 * sum / double(x.size());
}

struct Sorted {
  double error;  ///< largest of a row's mean over particles and time
  double lost;   ///< of the mean C
  double speed;  ///< mean velocity over that of the exact profile for the mean diameter
};
/// Errors of the means over the last tenth of a time (s).
Sorted sorted(Slope const& slope, double mean, double faster, double time) {
  using namespace fields;
  auto solver = mixture(slope, mean, faster);
  auto across = solver.settings().physics.transport.closure;
  across.chi_V *= std::cos(exact(slope).angle);  // grains segregate along gravity, not along the normal of the slope
  std::vector<double> sum(std::size_t(slope.rows)), of_exact(sum.size()), number(sum.size());
  std::optional<GrainEquilibrium> expected;
  double total = 0;
  for (int k = 0; k <= 100; ++k) {
    solver.run((0.9 + 0.001 * k) * time);
    auto const x = solver.material().to_host(position);
    if (k == 0) expected.emplace(across, depth_of(x), mean);
    auto const C = solver.material().to_host(concentration);
    total = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      auto const row = std::size_t(std::clamp(int(x[i][1] / depth * slope.rows), 0, slope.rows - 1));
      sum[row] += C[i], of_exact[row] += (*expected)(x[i][1]), number[row] += 1;
      total += C[i] / double(x.size());
    }
  }
  Sorted found{0, std::abs(total - mean), mean_velocity(solver) / (0.6 * exact(slope).velocity(depth))};
  for (std::size_t k = 0; k < sum.size(); ++k)
    found.error = std::max(found.error, std::abs(sum[k] - of_exact[k]) / std::max(number[k], 1.0));
  UNSCOPED_INFO(slope.angle << " degrees, " << slope.rows << " rows, mean C " << mean << ", " << faster
                            << " times as fast, " << time << " s: error " << found.error << ", lost " << found.lost
                            << ", speed " << found.speed);
  show_packing(solver);
  return found;
}

}  // namespace

TEST_CASE("grains of two sizes find their equilibrium in a flow down a slope") {
  auto const found = sorted({.angle = 24}, 0.5, 30, 0.25);
  CHECK(found.error < 0.03);
  CHECK(found.lost < 1e-12);
}
TEST_CASE("grains of two sizes find their equilibrium in a flow down a slope, finer and at their own pace", "[.long]") {
  auto const fine = sorted({.angle = 24, .rows = 40}, 0.5, 30, 0.25);
  CHECK(fine.error < 0.01);
  CHECK(fine.lost < 1e-12);
  for (double const mean : {0.5, 0.2}) {
    auto const slow = sorted({.angle = 24}, mean, 1, 10);
    CHECK(slow.error < 0.03);
    CHECK(slow.lost < 1e-12);
  }
}

}  // namespace scree::test::inclined::segregating_flow_tests
