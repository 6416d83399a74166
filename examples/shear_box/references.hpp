// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "case.hpp"
#include "reference/exact.hpp"
#include "reference/finite_volume_2d.hpp"

#include <fmt/format.h>

#include <functional>
#include <limits>
#include <string>

// The reference solutions of a run. Lengths are in H, times in T; X, Z are material coordinates.
namespace shear_box {

/// A solution C(X, Z) at one time.
using Solution = std::function<double(double X, double Z)>;

/// Reference solutions at some times. `best` solves the same problem as the run; `one_dimensional` neglects the
/// inclination of the walls.
struct References {
  std::string best_name, one_dimensional_name;
  std::vector<double> times;
  std::vector<Solution> best, one_dimensional;
};

namespace detail {

inline reference::Coefficients dimensionless(Options const& o) {
  auto const [V, D] = coefficients(o);
  double const H = o.geometry.height, T = o.geometry.period;
  return {.velocity = V * T / H, .diffusivity = D * T / (H * H)};
}

template <class Closure>
reference::Problem<Closure> problem(Options const& o, Closure const& closure) {
  return {.flux = {.amplitude = o.flux_amplitude(), .kappa = o.flux_asymmetry()},
          .closure = closure,
          .shear_amplitude = o.geometry.upright ? 0 : gamma0(o),
          .width = o.geometry.width / o.geometry.height};
}

template <class Closure>
void solve_profiles(References& found, reference::Problem<Closure> const& problem) {
  found.one_dimensional_name = "finite volumes in z, 2000 cells";
  for (auto const& profile : reference::solve_1d(problem, found.times))
    found.one_dimensional.push_back([profile](double, double Z) { return profile(Z); });
}

inline void take_series(References& found, reference::Coefficients const& coefficients) {
  found.one_dimensional_name = "exact series in z";
  reference::ExactSeries const series(coefficients);
  for (double time : found.times)
    found.one_dimensional.push_back([series, time](double, double Z) { return series(Z, time); });
}

template <class Closure>
void solve_all(References& found, Options const& o, Closure const& closure) {
  auto const problem = detail::problem(o, closure);
  bool const has_series = std::is_same_v<Closure, reference::ConstantClosure> && problem.flux.amplitude == 1 &&
                          problem.flux.kappa == 0 && closure.mean.peclet() > 0 && closure.mean.peclet() <= 100;
  if (has_series)
    take_series(found, closure.mean);
  else
    solve_profiles(found, problem);
  if (o.geometry.upright) {
    found.best_name = found.one_dimensional_name;
    found.best = found.one_dimensional;
    return;
  }
  found.best_name = fmt::format("finite volumes in (X, Z), extrapolated to zero from cells of {} H and {} H",
                                o.output.reference_spacing, 2 * o.output.reference_spacing);
  auto const fields = reference::solve_2d_extrapolated(problem, found.times, o.output.reference_spacing);
  for (std::size_t k = 0; k < fields.size(); ++k)
    if (found.times[k] > 0)
      found.best.push_back([field = fields[k]](double X, double Z) { return field(X, Z); });
    else  // a jump cannot be interpolated
      found.best.push_back([](double, double Z) { return reference::initial_mean(Z - 1e-9, Z + 1e-9); });
}

}  // namespace detail

/// Returns references with NaN for all values, for use before they are solved.
inline References unsolved_references(std::vector<double> const& times) {
  Solution const missing = [](double, double) { return std::numeric_limits<double>::quiet_NaN(); };
  std::vector<Solution> const all(times.size(), missing);
  return {.best_name = "none", .one_dimensional_name = "none", .times = times, .best = all, .one_dimensional = all};
}

/// Returns the references at the given times (in T, increasing).
inline References solve_references(Options const& o, std::vector<double> const& times) {
  References found{.best_name = {}, .one_dimensional_name = {}, .times = times, .best = {}, .one_dimensional = {}};
  auto const mean = detail::dimensionless(o);
  if (o.model.closure == Closure::constant)
    detail::solve_all(found, o, reference::ConstantClosure{.mean = mean});
  else
    detail::solve_all(found, o,
                      reference::ShearRateClosure{.mean = mean,
                                                  .small_diameter = o.geometry.d_small,
                                                  .large_diameter = o.geometry.d_large,
                                                  .reference_diameter = o.model.d_bar});
  return found;
}

}  // namespace shear_box
