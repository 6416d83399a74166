// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "fields.hpp"
#include "problem.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

// A finite-volume solver in height. The flux between two cells and the time integrator also serve the two-dimensional
// solver.
namespace shear_box::reference {

/// The concentration and V F at one end of an edge between two cells.
struct EdgeEnd {
  double C;
  double percolation;
};

/// The flux between two cells of size h at the mean shear rate, positive downwards (small grains percolate down):
///   D (C_up - C_low)/h + ((V F)_up + (V F)_low)/2
/// The flux is central and therefore second-order. C stays in [0, 1] if D >= h V A/2, because V F <= V A C and V F <= V
/// A (1 - C). A smaller D (a cell Peclet number above 2/A) is raised to this value; in sufficiently small cells this
/// never happens.
template <class Closure>
struct EdgeFlux {
  Problem<Closure> problem;
  double h;

  double lowest_diffusivity(double C) const { return 0.5 * h * problem.flux.amplitude * problem.closure.velocity(C); }

  double downwards(EdgeEnd upper, EdgeEnd lower) const {
    double const floor = std::max(lowest_diffusivity(upper.C), lowest_diffusivity(lower.C));
    double const D = std::max(problem.closure.diffusivity(0.5 * (upper.C + lower.C)), floor);
    return D / h * (upper.C - lower.C) + 0.5 * (upper.percolation + lower.percolation);
  }

  double sideways(double from, double to) const {
    return problem.closure.diffusivity(0.5 * (from + to)) / h * (from - to);
  }

  double largest_diffusivity() const {
    double D = 0.0;
    for (int i = 0; i <= 100; ++i)
      D = std::max({D, problem.closure.diffusivity(0.01 * i), lowest_diffusivity(0.01 * i)});
    return D;
  }
};

struct TimeStepping {
  double euler_limit;  // largest forward Euler step that keeps C in [0, 1]
  double longest;      // largest step that resolves changes in time

  double step(int stages) const { return std::min(longest, (stages - 1) * euler_limit); }
};

/// The optimal strong-stability-preserving Runge-Kutta method of second order with s stages (Gottlieb, Ketcheson & Shu
/// 2009): s forward Euler steps of dt/(s - 1), then the weighted average of the initial state (weight 1/s) and the
/// result of these steps. This convex combination of Euler steps keeps C in [0, 1] whenever the Euler steps do, so dt
/// may be s - 1 Euler limits at the cost of s stages.
///
/// Op: void op.euler(double const* C, double* result, double t, double dt)   result = C + dt dC/dt(C, t)
template <class Op>
class SspRungeKutta {
 public:
  SspRungeKutta(Op& op, TimeStepping stepping, std::size_t cells)
      : op_(op), stages_(2), step_(stepping.step(2)), stage_(cells), next_(cells) {
    for (int stages = 3; stages <= 10; ++stages)  // chooses the fewest stages per unit of time
      if (stages * step_ < stages_ * stepping.step(stages)) {
        stages_ = stages;
        step_ = stepping.step(stages);
      }
  }

  void advance(std::vector<double>& C, double from, double to) {
    auto const steps = static_cast<long>(std::ceil((to - from) / step_ - 1e-9));
    for (long n = 0; n < steps; ++n)
      step(C, from + (to - from) * static_cast<double>(n) / static_cast<double>(steps),
           (to - from) / static_cast<double>(steps));
  }

 private:
  void step(std::vector<double>& C, double t, double dt) {
    double const stage_dt = dt / (stages_ - 1);
    op_.euler(C.data(), stage_.data(), t, stage_dt);
    for (int s = 1; s < stages_; ++s) {
      op_.euler(stage_.data(), next_.data(), t + s * stage_dt, stage_dt);
      std::swap(stage_, next_);
    }
    double const old_weight = 1.0 / stages_;
    for (std::size_t i = 0; i < C.size(); ++i) C[i] = stage_[i] + old_weight * (C[i] - stage_[i]);
  }

  Op& op_;
  int stages_;
  double step_;
  std::vector<double> stage_, next_;
};

namespace detail {

/// A finite-volume discretisation of C_t = (V F + D C_z)_z without flux at z = 0 and 1. Time is the clock of the
/// closure, see SegregationClosure.
template <class Closure>
class Column {
 public:
  Column(Problem<Closure> const& problem, int cells)
      : edge_{problem, 1.0 / cells}, percolation_(cells), flux_(cells + 1, 0.0) {}

  void euler(double const* C, double* result, double /*clock*/, double dt) {
    int const n = static_cast<int>(percolation_.size());
    EdgeFlux<Closure> const edge = edge_;  // a copy, which stores to arrays of double cannot alias
    for (int i = 0; i < n; ++i) percolation_[i] = edge.problem.percolation(C[i]);
    for (int i = 1; i < n; ++i) flux_[i] = edge.downwards({C[i], percolation_[i]}, {C[i - 1], percolation_[i - 1]});
    for (int i = 0; i < n; ++i) result[i] = C[i] + dt / edge.h * (flux_[i + 1] - flux_[i]);
  }

  // Returns three quarters of the step h^2/(2 D) at which the two edges of a cell would take all of its content. With
  // h^2/(2 D) itself the method might not damp the shortest wave at all, and the initial jump contains this wave.
  double euler_limit() const { return 0.75 * edge_.h * edge_.h / (2.0 * edge_.largest_diffusivity()); }

 private:
  EdgeFlux<Closure> edge_;
  std::vector<double> percolation_;
  std::vector<double> flux_;  // downwards through the lower faces of the cells; the first and last stay zero
};

}  // namespace detail

/// Returns the profiles at the given times (increasing, in periods).
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
