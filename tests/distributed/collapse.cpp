// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "on_ranks.hpp"

#include <support/formulations.hpp>

#include <scree/granular/granular.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/setup/setup.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::collapse_tests {
using namespace fields;
namespace {

template <class Real>
struct Collapse : Formulation<2, Real> {
  using space = Space;
  using physics = Granular<>;
};
template <class Real>
struct Staggered : Collapse<Real> {
  using integrator = SymplecticEuler;
};

/// Its forces read what a projection stores for neighbours.
struct ObjectiveModels : GranularModels {
  using strain = ObjectiveStrain;
};
template <class F>
struct Objective : F {
  using physics = Granular<ObjectiveModels>;
};

/// A column that is thrown to the right and falls apart between walls.
template <class F>
Solver<F> column(Space const& space, SolverSettings<F> settings) {
  using real = typename F::real;
  double const dr = 0.01;
  settings.spacing = dr;
  settings.physics.law = {.elastic = {1e5, 0.3, 1500}, .grains = {5e-4}};
  settings.physics.filter.period = 7;
  Solver<F> solver(space, settings, cast<real>(fill_lattice(Box<2>{{0, 0}, {0.2, 0.3}}, dr)),
                   cast<real>(wall_around(Box<2>{{0, 0}, {0.8, 0.5}}, dr, 4)));
  solver.set(velocity, [](auto const& x) { return Vec<2, real>(1, real(0.1) * x[1]); });
  return solver;
}

}  // namespace

TEMPLATE_TEST_CASE("a collapsing column has the same bits on any number of ranks", "", double, float) {
  int const steps = 400;
  using F = Collapse<TestType>;
  auto const on = [&](int ranks, DividedCase<Space> const& divided = {}) {
    return outcome_on<F>(ranks, steps, column<OnRanks<F>>, divided);
  };
  auto const one = on(1);
  CHECK(one.builds > 10);
  for (int ranks : {2, 3, 4}) {
    INFO(ranks << " ranks");
    auto const several = on(ranks);
    CHECK(several.hash == one.hash);
    CHECK(several.builds == one.builds);
    CHECK(several.migrated > 10);
    CHECK(several.ghosts > 100);
  }
  auto const slabs = on(3, {.slabs = 0, .most_imbalance = 1.05});
  CHECK(slabs.hash == one.hash);
  CHECK(slabs.divisions > 1);
  CHECK(on(2, {.slabs = 1}).hash == one.hash);
}

TEMPLATE_TEST_CASE("a case on ranks has the bits of a solver of its own", "", Collapse<double>, Staggered<double>,
                   Objective<Collapse<double>>, Objective<Staggered<double>>) {
  using F = TestType;
  auto solver = column<Whole<F>>(Space(), {});
  for (int k = 0; k < 400; ++k) solver.step(1);
  auto const ranks = outcome_on<F>(2, 400, column<OnRanks<F>>);
  CHECK(ranks.hash == state_hash(solver));
  CHECK(ranks.time == solver.time());
  CHECK(ranks.builds == solver.neighbour_builds());
}

TEST_CASE("a reproducible run continues from a snapshot with the same bits", "") {
  using F = Collapse<double>;
  auto solver = column<Whole<F>>(Space(), {}), other = column<Whole<F>>(Space(), {});
  for (int k = 0; k < 37; ++k) solver.step(1);
  other.restore(solver.snapshot());
  for (int k = 0; k < 60; ++k) solver.step(1), other.step(1);
  CHECK(state_hash(other) == state_hash(solver));
  CHECK(other.neighbour_builds() == solver.neighbour_builds());
}

TEST_CASE("sorting does not change the bits of a reproducible run", "") {
  using F = Staggered<double>;
  auto const sorted = [](int period) {
    SolverSettings<Whole<F>> settings{.sort_period = period};
    auto solver = column<Whole<F>>(Space(), settings);
    for (int k = 0; k < 10; ++k) solver.step(1);
    return state_hash(solver);
  };
  CHECK(sorted(10) == sorted(0));
}

}  // namespace scree::test::collapse_tests
