// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "grain_equilibrium.hpp"
#include "inclined.hpp"
#include "profile_of_grains.hpp"

#include <scree/granular/segregating.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/segregation/conservative.hpp>
#include <scree/segregation/shear_rate_closure.hpp>
#include <scree/segregation/trewhela_closure.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
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
template <class Closure>
using Sorting = SegregatingGranular<Mechanics, ConservativeSegregation<Closure>>;

/// An even mixture in Bagnold flow of its mean diameter.
template <class Closure>
Solver<GranularCase<2, Sorting<Closure>, double, SymplecticEuler>> mixture(Slope const& slope, double mean,
                                                                           Closure const& closure) {
  using namespace fields;
  Bagnold const flow = exact(slope);
  double const dr = depth / slope.rows, length = 10 * dr;
  Sorting<Closure> physics;
  physics.mechanics.law = {{.elastic = flow.law.elastic, .grains = {closure.d_small, closure.d_large}}};
  physics.mechanics.gravity = {g, flow.angle};
  physics.mechanics.viscosity_speed = slope.viscosity_speed;
  physics.mechanics.cfl = 0.6;
  physics.transport.closure = closure;
  Solver<GranularCase<2, Sorting<Closure>, double, SymplecticEuler>> solver(
      {.spacing = dr, .physics = physics, .periods = {{0, 0, length}}, .warn = {}},
      fill_lattice(Box<2>{{0, 0}, {length, depth}}, dr), fill_lattice(Box<2>{{0, -4 * dr}, {length, 0}}, dr));
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
/// The exact concentration over the height (m) for a depth (m).
using Expected = std::function<std::function<double(double)>(double)>;
/// Errors of the means over the last tenth of a time (s).
template <class Closure>
Sorted sorted(Slope const& slope, double mean, Closure const& closure, Expected const& of_depth, double time) {
  using namespace fields;
  auto solver = mixture(slope, mean, closure);
  std::vector<double> sum(std::size_t(slope.rows)), of_exact(sum.size()), number(sum.size());
  std::function<double(double)> expected;
  double total = 0;
  for (int k = 0; k <= 100; ++k) {
    solver.run((0.9 + 0.001 * k) * time);
    auto const x = solver.material().to_host(position);
    if (k == 0) expected = of_depth(depth_of(x));
    auto const C = solver.material().to_host(concentration);
    total = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      auto const row = std::size_t(std::clamp(int(x[i][1] / depth * slope.rows), 0, slope.rows - 1));
      sum[row] += C[i], of_exact[row] += expected(x[i][1]), number[row] += 1;
      total += C[i] / double(x.size());
    }
  }
  Sorted found{0, std::abs(total - mean), mean_velocity(solver) / (0.6 * exact(slope).velocity(depth))};
  for (std::size_t k = 0; k < sum.size(); ++k)
    found.error = std::max(found.error, std::abs(sum[k] - of_exact[k]) / std::max(number[k], 1.0));
  UNSCOPED_INFO(slope.angle << " degrees, " << slope.rows << " rows, mean C " << mean << ", " << time << " s: error "
                            << found.error << ", lost " << found.lost << ", speed " << found.speed);
  show_packing(solver);
  return found;
}

/// Grains of 2/3 and 4/3 of the usual diameter, which change places `faster` times as fast as usual.
Sorted sorted_by_shear_rate(Slope const& slope, double mean, double faster, double time) {
  ShearRateClosure const closure{
      .chi_V = 0.11 * faster, .chi_D = 0.0307 * faster, .d_small = 2.0 / 3 * grain, .d_large = 4.0 / 3 * grain};
  auto across = closure;
  across.chi_V *= std::cos(exact(slope).angle);  // grains segregate along gravity, not along the normal of the slope
  return sorted(
      slope, mean, closure, [&](double thick) { return GrainEquilibrium(across, thick, mean); }, time);
}
/// Grains of 8/9 and 10/9 of the usual diameter, which segregate more slowly under the weight of others.
Sorted sorted_under_load(Slope const& slope, double mean, double faster, double time) {
  Bagnold const flow = exact(slope);
  TrewhelaClosure const usual{
      .d_small = 8.0 / 9 * grain, .d_large = 10.0 / 9 * grain, .grain_density = flow.law.grain_density};
  auto closure = usual;
  closure.A *= faster, closure.B *= faster;
  closure.gravity = 0;  // not that of the flow, which the mechanics gives
  auto const expected = [&](double thick) {
    return ProfileOfGrains(
        [&, thick](double z, double C) {
          double const d = usual.d_large - (usual.d_large - usual.d_small) * C, excess = 0.25;
          double const load =
              flow.law.density() * g * std::cos(flow.angle) * (thick - z) / (flow.law.grain_density * g);
          return std::cos(flow.angle) * usual.B / usual.A * (excess + usual.E * (1 - C) * excess * excess) /
                 (usual.C * d + load);
        },
        thick, mean);
  };
  return sorted(slope, mean, closure, expected, time);
}

}  // namespace

TEST_CASE("grains of two sizes find their equilibrium in a flow down a slope") {
  auto const found = sorted_by_shear_rate({.angle = 24}, 0.5, 30, 0.25);
  CHECK(found.error < 0.03);
  CHECK(found.lost < 1e-12);
}
TEST_CASE("grains of two sizes find their equilibrium in a flow down a slope, finer and at their own pace", "[.long]") {
  auto const fine = sorted_by_shear_rate({.angle = 24, .rows = 40}, 0.5, 30, 0.25);
  CHECK(fine.error < 0.01);
  CHECK(fine.lost < 1e-12);
  for (double const mean : {0.5, 0.2}) {
    auto const slow = sorted_by_shear_rate({.angle = 24}, mean, 1, 10);
    CHECK(slow.error < 0.03);
    CHECK(slow.lost < 1e-12);
  }
}

TEST_CASE("grains that segregate more slowly under a load find their equilibrium in a flow down a slope") {
  auto const found = sorted_under_load({.angle = 24}, 0.5, 30, 0.25);
  CHECK(found.error < 0.01);
  CHECK(found.lost < 1e-12);
}
TEST_CASE("grains that segregate more slowly under a load find their equilibrium in a flow down a slope, finer",
          "[.long]") {
  for (double const angle : {22.0, 24.0}) {
    auto const fine = sorted_under_load({.angle = angle, .rows = 40}, 0.5, 30, angle == 22 ? 0.5 : 0.25);
    CHECK(fine.error < 0.01);
    CHECK(fine.lost < 1e-12);
  }
}

}  // namespace scree::test::inclined::segregating_flow_tests
