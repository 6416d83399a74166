// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/distributed/gathered.hpp>
#include <scree/distributed/other_parts.hpp>
#include <scree/distributed/run_on_parts.hpp>
#include <scree/granular/granular.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <tuple>

namespace scree::test {
namespace {

template <class Real>
struct Collapse : Formulation<2, Real> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Granular<>;
  template <class P>
  using search = ReproducibleList<P>;
};
template <class Real>
struct OnParts : Collapse<Real> {
  template <class P>
  using ghosts = OtherParts<P>;
};

/// A column that falls apart.
template <class F>
Solver<F> column(typename F::space const& space, SolverSettings<F> settings) {
  double const dr = 0.01;
  settings.spacing = dr;
  settings.physics.law = {.elastic = {1e5, 0.3, 1500}, .grains = {5e-4}};
  settings.physics.filter.period = 7;
  Box<2> const room{{0, 0}, {0.8, 0.5}};
  auto const points = [](auto const& all) {
    std::vector<Vec<2, typename F::real>> cast;
    for (auto const& x : all) cast.push_back(x.template cast<typename F::real>());
    return cast;
  };
  Solver<F> solver(space, settings, points(fill(Box<2>{{0, 0}, {0.2, 0.3}}, dr)), points(wall_around(room, dr, 4)));
  return solver;
}

struct Outcome {
  std::uint64_t hash = 0;
  long builds = 0, steps = 0;
  std::int64_t migrated = 0;
};
template <class F>
Outcome outcome_on(int parts, int steps) {
  Outcome outcome;
  run_on_parts<typename F::space>(parts, [&](auto const& team, auto const& space) {
    SolverSettings<F> settings;
    settings.parts.team = team;
    auto solver = column<F>(space, settings);
    for (int k = 0; k < steps; ++k) solver.step(1);
    auto const hash = state_hash(solver);
    if (team.part() == 0) outcome = {hash, solver.neighbour_builds(), solver.steps(), 0};
  });
  return outcome;
}

}  // namespace

TEMPLATE_TEST_CASE("a collapsing column has the same bits on any number of parts", "", double, float) {
  int const steps = 600;
  auto const one = outcome_on<OnParts<TestType>>(1, steps);
  CHECK(one.builds > 5);
  for (int parts : {2, 3, 4}) {
    INFO(parts << " parts");
    auto const several = outcome_on<OnParts<TestType>>(parts, steps);
    CHECK(several.hash == one.hash);
    CHECK(several.builds == one.builds);
  }
}

}  // namespace scree::test
