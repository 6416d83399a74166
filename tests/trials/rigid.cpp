// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Rigid bodies in steps that are repeated.
#define SCREE_TRIALS_ON_HOST
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

#include <support/points.hpp>

#include <catch2/catch_test_macros.hpp>

namespace scree::test::rigid_tests {
using namespace fields;
namespace {

struct Stone : RigidBody {
  static constexpr std::string_view name = "stone";
};
struct Impact : Formulation<2> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Granular<>;
  using bodies = Bodies<Material, Stone>;
};
/// A stone among grains that have moved slowly, and then are thrown against it.
Solver<Impact> resting() {
  Granular<> physics;
  physics.law.elastic = {1e5, 0.3, 1500};
  physics.law.grains = {0.01};
  physics.gravity = {0.01};
  Groups<2> stones;
  stones.add("stone", fill_lattice(Box<2>{{0.8, 0}, {1.2, 0.4}}, 0.1));
  Rigid<2> stone;
  stone.properties.mass = 200;
  stone.properties.centre = {1, 0.2};
  stone.properties.inertia(0, 0) = 5;
  return Solver<Impact>({.spacing = 0.1, .physics = physics, .rigid = {.bodies = {stone}}, .lost_share = 1},
                        particles_of<Material>(fill_lattice(Box<2>{{0, 0}, {0.8, 0.4}}, 0.1)),
                        particles_of<Stone>(stones));
}
void throw_grains(Solver<Impact>& solver) {
  solver.set(velocity, [](auto const&) { return Vec<2, double>(4, 0); });
}
}  // namespace

TEST_CASE("rigid bodies return to the beginning of a trial with the grains") {
  double const first = 0.5, end = 0.6;
  auto by_run = resting(), by_step = resting();
  by_run.run(first);
  while (by_step.time() < first) by_step.step(first - by_step.time());
  throw_grains(by_run), throw_grains(by_step);
  by_run.run(end);
  while (by_step.time() < end) by_step.step(end - by_step.time());
  INFO("failed trials " << by_run.failed_trials());
  CHECK(by_run.failed_trials() > 0);
  CHECK(by_run.steps() == by_step.steps());
  auto const &a = by_run.body<RigidStates>(), &b = by_step.body<RigidStates>();
  CHECK(a.to_host(rigid_velocity)[0][0] > 0.1);
  CHECK(a.to_host(rigid_centre) == b.to_host(rigid_centre));
  CHECK(a.to_host(rigid_attitude) == b.to_host(rigid_attitude));
  CHECK(a.to_host(rigid_velocity) == b.to_host(rigid_velocity));
  CHECK(a.to_host(seen_acceleration) == b.to_host(seen_acceleration));
  CHECK(by_run.material().to_host(position) == by_step.material().to_host(position));
}

}  // namespace scree::test::rigid_tests
