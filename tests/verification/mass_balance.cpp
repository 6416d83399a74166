// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "turning_drum.hpp"

#include <scree/granular/segregating.hpp>
#include <scree/segregation/shear_rate_closure.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>

// A long run conserves its particles, their volumes and the small grains, and they stay in the domain.
namespace scree::test::drum::mass_balance_tests {
namespace {

struct Models : GranularModels {
  using law = VolumeMemory<MuOfI<BidisperseGrains>>;
  using volume_control = VolumeConsistency;
};
using Mechanics = Granular<Models>;
using Sorting = SegregatingGranular<Mechanics, ConservativeSegregation<ShearRateClosure>>;

double const d_small = 0.25e-3, d_large = 0.5e-3;  // m

auto sorting(Numbers const& numbers) {
  Sorting physics;
  physics.mechanics.law.elastic = beads(numbers.sound_speed).elastic;
  physics.mechanics.law.grains = {.d_small = d_small, .d_large = d_large};
  physics.mechanics.viscosity_speed = numbers.viscosity_speed;
  physics.mechanics.cfl = 0.4;
  physics.mechanics.volume_control.per_strain = 3;
  physics.transport.closure = {.d_small = d_small, .d_large = d_large};
  physics.period = 5;
  auto solver = turning(physics, numbers, 0.1);
  solver.set(fields::concentration, [](auto const& x) { return 0.5 + 0.4 * std::sin(x[0] / 0.005); });
  return solver;
}

/// Contents of the drum, m^2.
struct Contents {
  std::size_t grains = 0, walls = 0;
  double volume = 0, small = 0, large = 0, least = 1, most = 0;
  double farthest = 0;  ///< from the axis, m
};
template <class S>
Contents contents_of(S const& solver) {
  using namespace fields;
  auto const V = solver.material().to_host(volume), C = solver.material().to_host(concentration);
  auto const x = solver.material().to_host(position);
  Contents sum;
  sum.grains = x.size(), sum.walls = std::size_t(solver.wall().size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    sum.volume += V[i], sum.small += V[i] * C[i], sum.large += V[i] * (1 - C[i]);
    sum.least = std::min(sum.least, C[i]), sum.most = std::max(sum.most, C[i]);
    sum.farthest = std::max(sum.farthest, x[i].norm());
  }
  return sum;
}

void run_and_compare(Numbers const& numbers, long steps) {
  using namespace fields;
  auto solver = sorting(numbers);
  auto const volumes = solver.material().to_host(volume);
  Contents const before = contents_of(solver);
  auto const C = solver.material().to_host(concentration);
  while (solver.steps() < steps) solver.step(1);
  Contents const after = contents_of(solver);
  INFO(solver.steps() << " steps, " << solver.time() << " s, " << after.grains << " particles");
  INFO("small grains " << after.small / before.small - 1 << ", large ones " << after.large / before.large - 1
                       << "; C from " << after.least << " to " << after.most << "; farthest "
                       << after.farthest / radius);
  show_packing(solver);
  CHECK(after.grains == before.grains);
  CHECK(after.walls == before.walls);
  CHECK(solver.material().to_host(volume) == volumes);
  // Each of some 30 pairs gives to one particle what the other loses, rounded; a random walk at worst.
  double const rounding = 2.2e-16 * std::sqrt(30.0 * double(steps) * double(after.grains));
  CHECK(std::abs(after.small / before.small - 1) < rounding);
  CHECK(std::abs(after.large / before.large - 1) < rounding);
  CHECK(after.least >= 0);
  CHECK(after.most <= 1);
  double changed = 0;
  auto const now = solver.material().to_host(concentration);
  for (std::size_t i = 0; i < C.size(); ++i) changed = std::max(changed, std::abs(now[i] - C[i]));
  CHECK(changed > 1e-3);  // grains have segregated
  CHECK(after.farthest < radius + numbers.spacing / 2);
}

}  // namespace

TEST_CASE("a drum keeps its grains, each size") { run_and_compare({}, 1000); }
TEST_CASE("a drum keeps its grains over a million steps", "[.long]") { run_and_compare({.spacing = 5e-3}, 1'000'000); }

}  // namespace scree::test::drum::mass_balance_tests
