// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "edge_flux.hpp"
#include "profile.hpp"
#include "ssp_runge_kutta.hpp"

#include <vector>

namespace shear_box::reference {

namespace detail {

/// C_t = (V F + D C_z)_z in finite volumes, no flux at z = 0 and 1. Time is the closure's clock, see closure.hpp.
template <class Closure>
class Column {
 public:
  Column(Problem<Closure> const& problem, int cells)
      : edge_{problem, 1.0 / cells}, percolation_(cells), flux_(cells + 1, 0.0) {}

  void euler(double const* C, double* result, double /*clock*/, double dt) {
    int const n = static_cast<int>(percolation_.size());
    EdgeFlux<Closure> const edge = edge_;  // a copy: stores to arrays of double cannot alias it
    for (int i = 0; i < n; ++i) percolation_[i] = edge.problem.percolation(C[i]);
    for (int i = 1; i < n; ++i) flux_[i] = edge.downwards({C[i], percolation_[i]}, {C[i - 1], percolation_[i - 1]});
    for (int i = 0; i < n; ++i) result[i] = C[i] + dt / edge.h * (flux_[i + 1] - flux_[i]);
  }

  // The two edges of a cell take at most 2 D dt/h^2 of its content. The step is three quarters of that limit: at the
  // limit itself the method may not damp the shortest wave at all, which the initial step contains.
  double euler_limit() const { return 0.75 * edge_.h * edge_.h / (2.0 * edge_.largest_diffusivity()); }

 private:
  EdgeFlux<Closure> edge_;
  std::vector<double> percolation_;
  std::vector<double> flux_;  // downwards through the cells' lower faces; first and last stay zero
};

}  // namespace detail

/// Profiles at the given times (increasing, in periods).
template <class Closure>
std::vector<Profile> solve_1d(Problem<Closure> const& problem, std::vector<double> const& times, int cells = 2000) {
  require_increasing(times);
  detail::Column<Closure> column(problem, cells);
  Profile profile{.h = 1.0 / cells, .values = std::vector<double>(cells)};
  for (int i = 0; i < cells; ++i) profile.values[i] = initial_mean(i * profile.h, (i + 1) * profile.h);

  SspRungeKutta<detail::Column<Closure>> time_integrator(
      column, {.euler_limit = column.euler_limit(), .longest = 4.0 * profile.h}, profile.values.size());
  std::vector<Profile> profiles;
  double clock = 0.0;
  for (double time : times) {
    double const target = problem.closure.clock(time);
    time_integrator.advance(profile.values, clock, target);
    clock = target;
    profiles.push_back(profile);
  }
  return profiles;
}

}  // namespace shear_box::reference
