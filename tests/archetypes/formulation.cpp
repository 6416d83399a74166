// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "derived_field.hpp"
#include "diagnostics.hpp"
#include "grain_kinds.hpp"
#include "integrator.hpp"
#include "kernel.hpp"
#include "motion.hpp"
#include "observer.hpp"
#include "physics.hpp"
#include "search.hpp"
#include "shape.hpp"

#include <scree/mixing/intensity.hpp>
#include <scree/probes/region.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

#include <catch2/catch_test_macros.hpp>

#include <cmath>

// The smallest class for each role: it has only the members that the concept of the role requires.
namespace scree::test::formulation_tests {
using namespace fields;
namespace {

template <class OfMotion>
struct Least : Formulation<2> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = archetypes::Physics;
  using kernel = archetypes::Kernel;
  template <class P>
  using search = archetypes::Search<P>;
  using integrator = archetypes::Integrator;
  using motion = OfMotion;
  using diagnostics = archetypes::Output;
};

}  // namespace

TEST_CASE("a formulation of the least parts runs") {
  STATIC_CHECK(PairTerm<archetypes::Term, basis_of<Least<archetypes::Motion>>>);
  STATIC_CHECK(
      NeighbourSearch<archetypes::Search<basis_of<Least<archetypes::Motion>>>, basis_of<Least<archetypes::Motion>>>);
  using S = Solver<Least<archetypes::Motion>>;
  S solver({.spacing = 0.2}, fill_lattice(archetypes::Disc{}, 0.2));
  solver.set(concentration, [](auto const& x) { return x[0] > 0 ? 1.0 : 0.5; });
  auto const mean = [&] { return mean_in(solver, concentration, whole_space<2>()).value; };
  double const before = mean();
  int calls = 0;
  solver.run(2, {archetypes::counting<S>(calls)});
  CHECK(calls == 3);
  CHECK(std::abs(mean() - before) < 1e-12);
  solver.update_diagnostics();
  auto const C = solver.material().to_host(concentration), twice = solver.material().to_host(archetypes::doubled);
  double least = 1, most = 0;
  for (std::size_t i = 0; i < C.size(); ++i) {
    CHECK(twice[i] == 2 * C[i]);
    least = std::min(least, C[i]), most = std::max(most, C[i]);
  }
  CHECK(least > 0.5);
  CHECK(most < 1);
  CHECK(std::abs(mean_in(solver, archetypes::squared, whole_space<2>()).value - before * before) < 0.05);
  CHECK(segregation_intensity(solver, archetypes::OneKindEach{}).mean == Vec<2, double>(1, 0));
}

TEST_CASE("the least motion by group runs") {
  Solver<Least<archetypes::MotionsByGroup>> solver(
      {.spacing = 0.2}, Groups<2>().add("left", {{0, 0}, {0, 0.2}}).add("right", {{0.2, 0}, {0.2, 0.2}}));
  solver.set(concentration, [](auto const&) { return 1.0; });
  solver.run(1);
  CHECK(solver.material().to_host(concentration) == std::vector<double>(4, 1));
}

}  // namespace scree::test::formulation_tests
