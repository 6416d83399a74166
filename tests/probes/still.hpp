// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

// A material whose velocity a test sets, and whose position follows from it. Each wall particle carries the force (1,
// 2) or (1, 0, 2).
namespace scree::test {

struct Coasting {
  using evolves = Fields<Position, Velocity, Concentration, Stress>;
  std::tuple<> passes(Resolution const&) const { return {}; }
  std::tuple<> limits(Resolution const&) const { return {}; }
};

template <int Dim, class Real = double>
struct Still : Formulation<Dim, Real> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Coasting;
};

/// The unit square or cube, with ten particles along its side.
template <int Dim, class Real = double>
Solver<Still<Dim, Real>> unit_block(std::vector<Period> const& periods = {}, int sort_period = 0) {
  using vector = Vec<Dim, double>;
  auto const points = fill_lattice(Box<Dim>{vector::Zero(), vector::Constant(1)}, 0.1);
  return Solver<Still<Dim, Real>>(
      {.spacing = 0.1, .physics = {}, .periods = periods, .sort_period = sort_period, .start_checks = false},
      cast<Real>(points));
}

}  // namespace scree::test
