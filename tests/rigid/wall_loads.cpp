// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/granular.hpp>
#include <scree/granular/wall_forces.hpp>
#include <scree/solver/wall_loads.hpp>

#include <support/rigid_bodies.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

// Rigid bodies in the loads on walls.
namespace scree::test::wall_loads_tests {
namespace {
template <class Q>
struct Case : Formulated<Q, Granular<>, AtRest, WallForces> {
  using bodies = Bodies<Material, Wall, Block>;
};
}  // namespace

TEMPLATE_LIST_TEST_CASE("the load on a wall contains what rigid bodies press and rub on it", "", Policies) {
  using Q = TestType;
  constexpr int dim = Q::dim;
  using X = Vec<dim, double>;
  double const dr = 0.02;
  X low = X::Constant(-0.04), high = X::Constant(0.04);
  low[dim - 1] = 0, high[dim - 1] = 0.08;
  Box<dim> const block{low, high};
  Groups<dim> blocks, walls;
  blocks.add("block", fill_lattice(block, dr));
  walls.add("floor", floor_of<dim>(0.1, dr));
  Granular<> sand;
  sand.law = {.elastic = {1e6, 0.3, 1500}, .grains = {1e-3}};  // its stiffness is that of the contact
  Rigid<dim> body;
  body.properties = mass_properties(block, 2000, dr);
  body.velocity[0] = 0.2;
  Solver<Case<Q>> solver({.spacing = dr, .physics = sand, .rigid = {.bodies = {body}}},
                         particles_of<Material>(std::vector<Vec<dim, typename Q::real>>()), particles_of<Wall>(walls),
                         particles_of<Block>(blocks));
  for (int k = 0; k < 20; ++k) solver.step(1);
  auto const load = wall_load(solver, walls, "floor");
  solver.update_rates();
  auto const now = state_of(solver);
  INFO("load " << load.force[0] << ", " << load.force[dim - 1] << " N, on the block " << now.force[0] << ", "
               << now.force[dim - 1]);
  CHECK(now.force[0] < 0);
  CHECK(now.force[dim - 1] > 1);
  CHECK((load.force + now.force).norm() < ulps<Q>(100) * now.force.norm());
  auto const again = wall_load(solver, walls, "floor");
  CHECK(again.force == load.force);
}

}  // namespace scree::test::wall_loads_tests
