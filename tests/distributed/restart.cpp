// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "on_ranks.hpp"

#include <support/formulations.hpp>

#include <scree/formulation/combined.hpp>
#include <scree/granular/granular.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/laws/mixture_density.hpp>
#include <scree/segregation/size_density_closure.hpp>
#include <scree/segregation/size_ratio_closure.hpp>
#include <scree/segregation/species_segregation.hpp>
#include <scree/setup/setup.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

// Snapshots of a case on ranks fit any number of ranks.
namespace scree::test::restart_tests {
using namespace fields;
namespace {

using Catch::Matchers::ContainsSubstring;

/// A column that is thrown to the right and falls apart between walls.
struct Column : Formulation<2> {
  using space = Space;
  using physics = Granular<>;
};
template <class F>
Solver<F> column(Space const& space, SolverSettings<F> settings) {
  double const dr = 0.01;
  settings.spacing = dr;
  settings.physics.law = {.elastic = {1e5, 0.3, 1500}, .grains = {5e-4}};
  settings.physics.filter.period = 7;
  Solver<F> solver(space, settings, fill_lattice(Box<2>{{0, 0}, {0.2, 0.3}}, dr),
                   wall_around(Box<2>{{0, 0}, {0.8, 0.5}}, dr, 4));
  solver.set(velocity, [](auto const& x) { return Vec<2, double>(1, 0.1 * x[1]); });
  return solver;
}
/// A fast shear flow of three sizes through periodic ends, in single precision, sorted.
struct Shear : Formulation<2, float> {
  using space = Space;
  using physics = Combined<Granular<>, SpeciesSegregation<SizeRatioClosure<3>>>;
  using integrator = SymplecticEuler;
};
template <class F>
Solver<F> shear(Space const& space, SolverSettings<F> settings) {
  double const dr = 0.05;
  settings.spacing = dr;
  settings.periods = {{0, 0, 1}};
  settings.sort_period = 30;
  settings.physics.mechanics.law = {.elastic = {1e5, 0.3, 1500}, .grains = {5e-3}};
  settings.physics.transport.closure = {.diameters = {2e-3, 4e-3, 8e-3}};
  Solver<F> solver(space, settings, cast<float>(fill_lattice(Box<2>{{0, 0}, {1, 0.6}}, dr)),
                   cast<float>(fill_lattice(Box<2>{{0, -4 * dr}, {1, 0}}, dr)));
  solver.set(velocity, [](auto const& x) { return Vec<2, float>(4 * x[1], 0); });
  solver.set(concentrations<3>, [](auto const& x) { return Vec<3, float>(0.5f - x[1] / 2, 0.25f, 0.25f + x[1] / 2); });
  return solver;
}

/// The same, of three sizes and densities in double precision, whose exchange is evaluated in every third step.
struct HeavyShear : Formulation<2> {
  struct Models : GranularModels {
    using law = MixtureDensity<MuOfI<>, 3>;
  };
  using space = Space;
  using physics = Combined<Granular<Models>, SpeciesSegregation<SizeDensityClosure<3>>>;
};
auto const make_heavy_shear = []<class F>(Space const& space, SolverSettings<F> settings) {
  double const dr = 0.05;
  settings.spacing = dr;
  settings.periods = {{0, 0, 1}};
  settings.sort_period = 30;
  settings.physics.mechanics.law = {{.elastic = {1e5, 0.3, 1500}, .grains = {5e-3}}, {3000, 1500, 800}};
  settings.physics.transport.closure = {
      .diameters = {2e-3, 4e-3, 6e-3}, .densities = {3000, 1500, 800}, .S_density = 0.3};
  settings.physics.period = 3;
  Solver<F> solver(space, settings, fill_lattice(Box<2>{{0, 0}, {1, 0.6}}, dr),
                   fill_lattice(Box<2>{{0, -4 * dr}, {1, 0}}, dr));
  solver.set(velocity, [](auto const& x) { return Vec<2, double>(4 * x[1], 0); });
  solver.set(concentrations<3>, [](auto const& x) { return Vec<3, double>(0.5 - x[1] / 2, 0.25, 0.25 + x[1] / 2); });
  return solver;
};

auto const make_column = [](Space const& space, auto settings) { return column(space, settings); };
auto const make_shear = [](Space const& space, auto settings) { return shear(space, settings); };

}  // namespace

TEST_CASE("a column has the same snapshot on any number of ranks, and continues from it on any number") {
  check_restarts<Column>(make_column, {0, 1, 37, 120}, 200);
}

TEST_CASE("a periodic flow has the same snapshot on any number of ranks, and continues from it on any number") {
  check_restarts<Shear>(make_shear, {0, 29, 30, 31, 50}, 90);
}

TEST_CASE(
    "a flow of species of different densities has the same snapshot on any number of ranks, and continues from it") {
  check_restarts<HeavyShear>(make_heavy_shear, {1, 29, 30, 31, 50}, 90);
}

TEMPLATE_TEST_CASE("a case on ranks and a solver of its own exchange snapshots", "", Column, Shear) {
  auto const make = [](Space const& space, auto settings) {
    if constexpr (std::is_same_v<TestType, Column>)
      return column(space, settings);
    else
      return shear(space, settings);
  };
  SolverSettings<Whole<TestType>> settings;
  auto alone = make(Space(), settings), other = make(Space(), settings);
  for (int k = 0; k < 40; ++k) alone.step(1);
  auto const of_whole = alone.snapshot();
  auto const of_ranks = snapshots_on<TestType>(3, {40}, make).front();
  CHECK(of_ranks.signature == of_whole.signature);
  for (int k = 0; k < 30; ++k) alone.step(1);
  CHECK(end_from<TestType>(of_whole, 2, 70, make) == state_hash(alone));
  other.restore(of_ranks);
  for (int k = 0; k < 30; ++k) other.step(1);
  CHECK(state_hash(other) == state_hash(alone));
}

TEST_CASE("a solver on ranks returns to an earlier snapshot during a run") {
  std::vector<std::uint64_t> ends;
  run_on_threads<Space>(3, [&](Team<Space> const& team, Space const& space) {
    SolverSettings<OnRanks<Column>> settings;
    settings.ranks.team = team;
    auto solver = column(space, settings);
    for (int k = 0; k < 40; ++k) solver.step(1);
    auto const earlier = solver.snapshot();
    for (int again = 0; again < 2; ++again) {
      for (int k = 0; k < 60; ++k) solver.step(1);
      auto const end = state_hash(solver);
      if (team.rank() == 0) ends.push_back(end);
      solver.restore(earlier);
    }
  });
  CHECK(ends.at(0) == ends.at(1));
}

TEST_CASE("fields of all ranks are there before the case is divided and afterwards, and their number is known") {
  run_on_threads<Space>(3, [&](Team<Space> const& team, Space const& space) {
    SolverSettings<OnRanks<Column>> settings;
    settings.ranks.team = team;
    auto solver = column(space, settings);
    auto const before = gathered<Material>(solver, position);
    solver.update_rates();
    auto const after = gathered<Material>(solver, position);
    if (team.rank() != 0) return;
    CHECK(before == after);
    CHECK(solver.material().everywhere() == long(after.size()));
    CHECK(solver.material().size() < int(after.size()));
  });
}

TEST_CASE("ranks refuse the snapshot of another case, and go on") {
  auto const snapshot = snapshots_on<Column>(2, {3}, make_column).front();
  auto other = snapshot;
  other.signature.replace(other.signature.find("material particles: "), 21, "material particles: 9");
  CHECK_THROWS_WITH(end_from<Column>(other, 2, 5, make_column),
                    ContainsSubstring("'material particles' is 600 in this"));
}

}  // namespace scree::test::restart_tests
