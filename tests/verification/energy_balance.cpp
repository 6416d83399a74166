// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "energy_ledger.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <numbers>
#include <sstream>

// The bed of a drum dissipates the work of the torque. Figures: docs/theory/verification.md.
namespace scree::test::drum::energy_balance_tests {
namespace {

/// All models by default, with the filter in a form that keeps the stress before it.
struct Models : GranularModels {
  using filter = WatchedFilter;
};
using Mechanics = Granular<Models>;

/// The mechanics of the bed, with the settings of the volume control by default.
Mechanics default_mechanics(Numbers const& numbers) {
  auto physics = mechanics<Mechanics>(numbers);
  physics.volume_control = {};
  return physics;
}

Ledger ledger_of(Mechanics const& physics, Numbers const& numbers) {
  return {physics.law.elastic, physics.viscosity_speed, wall_of(numbers)};
}

std::string table(Powers const& P) {
  std::ostringstream text;
  auto const row = [&](char const* name, double power) {
    text << name << " " << power << " W/m, " << 100 * power / P.by_torque << " %\n";
  };
  row("torque", P.by_torque), row("walls", P.by_walls), row("plastic", P.plastic), row("viscous", P.viscous);
  row("at walls", P.at_walls), row("volume", P.volume), row("filter", P.filter), row("step", P.of_step);
  row("stored", P.change), row("missing", P.by_torque - P.dissipated() - P.change);
  return text.str();
}

/// Means over a time, from every `stride`-th step; for the filter from all steps.
template <class S>
Powers mean_powers(S& solver, Ledger const& ledger, double until, int stride) {
  Powers sum;
  double const start = solver.time(), before = ledger.energy_of(solver).all();
  long samples = 0;
  double filter = 0;
  int const period = solver.settings().physics.filter_period();
  while (solver.time() < until) {
    if (solver.steps() % stride == 0) {
      Powers const P = ledger.step(solver);
      sum.add(P, 1);
      ++samples;
    } else {
      solver.step(1);
    }
    if (solver.steps() % period == 0) filter += ledger.filter_loss(solver);
  }
  Powers mean = Powers{}.add(sum, 1.0 / double(samples));
  mean.filter = filter / (solver.time() - start);
  mean.change = (ledger.energy_of(solver).all() - before) / (solver.time() - start);
  return mean;
}

}  // namespace

TEST_CASE("energy balances in every step") {
  Numbers const numbers;
  auto const physics = default_mechanics(numbers);
  auto solver = turning(physics, numbers, 0.1);
  solver.run(0.05);
  auto const ledger = ledger_of(physics, numbers);
  double worst = 0;
  Powers sum;
  for (int k = 0; k < 90; ++k) {
    Powers const P = ledger.step(solver);
    sum.add(P, 1);
    double const scale = std::abs(P.plastic) + std::abs(P.viscous) + std::abs(P.by_walls) + std::abs(P.of_step) +
                         std::abs(P.volume) + std::abs(P.filter) + std::abs(P.change);
    worst = std::max(worst, std::abs(P.by_walls - P.dissipated() - P.change) / scale);
  }
  INFO("largest gap " << worst << "\n" << table(sum));
  show_packing(solver);
  CHECK(worst < 1e-8);  // of the powers; dividing energies by a short step leaves no more digits
  CHECK(sum.plastic > 0);
  CHECK(sum.viscous > 0.01 * sum.plastic);
  CHECK(sum.filter != 0);
  // The torque on the group of the wall, of the state before each step, against the work done on the bed.
  CHECK(std::abs(sum.by_torque - sum.by_walls) < 0.02 * sum.by_torque);
  CHECK(std::abs(sum.by_torque - sum.dissipated() - sum.change) < 0.02 * sum.by_torque);
}

TEST_CASE("the torque of a steady drum is what its bed dissipates", "[.long]") {
  Numbers const numbers;
  auto const physics = default_mechanics(numbers);
  auto solver = turning(physics, numbers);
  double const turn = 2 * std::numbers::pi / rate;
  solver.run(turn / 3);
  Powers const P = mean_powers(solver, ledger_of(physics, numbers), turn / 3 + turn / 4, 7);
  WARN(table(P) << "packing " << solver.packing().text());
  CHECK(P.by_torque > 0);
  CHECK(std::abs(P.dissipated() + P.change - P.by_torque) < 0.02 * P.by_torque);
  CHECK(P.plastic > 0.5 * P.by_torque);
}

}  // namespace scree::test::drum::energy_balance_tests
