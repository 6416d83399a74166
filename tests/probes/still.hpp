// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

#include <scree/terms/wall_force.hpp>

// A material whose velocity a test sets, and whose position follows from it. Each wall particle carries the force (1,
// 2) or (1, 0, 2).
namespace scree::test {

struct PushWall {
  using reads = Fields<>;
  using writes = Fields<WallForce>;
  template <class I, class O>
  SCREE_FN void operator()(I const&, O& out) const {
    using vector = std::remove_cvref_t<decltype(out[wall_force])>;
    vector force = zero<vector>();
    force[0] = 1;
    force[vector::RowsAtCompileTime - 1] = 2;
    out[wall_force] = force;
  }
};
struct Pushed {
  auto passes(Resolution const&) const { return std::tuple(point_pass<Wall>("push", PushWall{})); }
};
struct Coasting {
  using evolves = Fields<Position, Velocity, Concentration, Stress>;
  std::tuple<> passes(Resolution const&) const { return {}; }
  std::tuple<> limits(Resolution const&) const { return {}; }
};

template <int Dim, class Real = double>
struct Still : Formulation<Dim, Real> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Coasting;
  using diagnostics = Pushed;
};

/// The unit square or cube, with ten particles along its side.
template <int Dim, class Real = double>
Solver<Still<Dim, Real>> unit_block(std::vector<Period> const& periods = {}, int sort_period = 0) {
  using vector = Vec<Dim, double>;
  auto const points = fill(Box<Dim>{vector::Zero(), vector::Constant(1)}, 0.1);
  auto const floor = fill(Box<Dim>{vector::Constant(-0.2), vector::Constant(0)}, 0.1);
  return Solver<Still<Dim, Real>>({.spacing = 0.1,
                                   .physics = {},
                                   .periods = periods,
                                   .sort_period = sort_period,
                                   .lost_share = 1,
                                   .start_checks = false},
                                  cast<Real>(points), cast<Real>(floor));
}

}  // namespace scree::test
