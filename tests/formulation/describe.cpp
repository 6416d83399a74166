// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/formulation/describe.hpp>

#include <scree/granular/granular.hpp>
#include <scree/granular/segregating.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/segregation/shear_rate_closure.hpp>
#include <scree/solver/solver.hpp>

#include <repository.hpp>
#include <support/formulations.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <fstream>
#include <iterator>

namespace scree::test::describe_tests {
using Catch::Matchers::ContainsSubstring;

TEST_CASE("the overview shows the step of a granular material as it is") {
  std::ifstream file(SCREE_REPOSITORY "/docs/overview.md");
  std::string const overview{std::istreambuf_iterator<char>(file), {}};
  CHECK_THAT(overview, ContainsSubstring("```text\n" + describe<Midpoint>(Granular<>{}, Resolution{}) + "```\n"));
}

TEST_CASE("a staggered step is described stage by stage, and conditions of passes are named") {
  SegregatingGranular<Granular<>, ConservativeSegregation<ShearRateClosure>> physics;
  physics.period = 2;
  Resolution odd;
  odd.steps = 1;
  auto const text = describe<SymplecticEuler>(physics, odd);
  auto const strain = text.find("scree::strain_rates: material over material and wall\n"),
             admit = text.find("scree::admit: material\n"), force = text.find("scree::acceleration: material");
  REQUIRE(strain != std::string::npos);
  CHECK(strain < admit);
  CHECK(admit < force);
  CHECK_THAT(text, ContainsSubstring("scree::transport: material over material (conditional, not in this step)\n"));
  CHECK_THAT(text, ContainsSubstring("update of velocity, position\n"));
  CHECK_THAT(describe<SymplecticEuler>(physics, Resolution{}),
             ContainsSubstring("scree::transport: material over material (conditional)\n"));
}

TEST_CASE("a solver describes its own step") {
  using P = Formulated<Policy<2, double, Kokkos::DefaultExecutionSpace>, Granular<>>;
  Granular<> physics{.law = {.elastic = {1e5, 0.3, 1500}, .grains = {1e-3}}};
  physics.filter.period = 7;
  auto const solver = solver_of<P>(open_bed<2>(Vec<2, double>(0.2, 0.2), 0.1), 0.1, physics);
  CHECK(describe(solver) == describe<Midpoint>(physics, solver.resolution()));
  CHECK_THAT(describe(solver), ContainsSubstring("a multiple of 7\n"));
}

}  // namespace scree::test::describe_tests
