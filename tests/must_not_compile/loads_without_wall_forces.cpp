// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: no pass computes `wall_force`: name WallForces in `diagnostics` of the formulation
#include <scree/granular/granular.hpp>
#include <scree/granular/wall_forces.hpp>
#include <scree/solver/solver.hpp>
#include <scree/solver/wall_loads.hpp>

struct Case : scree::Formulation<2> {
  using physics = scree::Granular<>;
#ifdef FIXED
  using diagnostics = scree::WallForces;
#endif
};

double force_on_floor(scree::Solver<Case>& solver, scree::Groups<2> const& walls) {
  return scree::wall_load(solver, walls, "floor").force[1];
}
