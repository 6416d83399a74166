// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "points.hpp"

#include <scree/solver/solver.hpp>

#include <algorithm>
#include <cmath>

// Solvers for tests of physics: small beds, and sums over them.
namespace scree::test {

/// A formulation with the basis of a test policy.
template <class Q, class Physics, class Motion = AtRest, class Diagnostics = NoDiagnostics>
struct Formulated : Formulation<Q::dim, typename Q::real> {
  using space = typename Q::space;
  using kernel = typename Q::kernel;
  using physics = Physics;
  using motion = Motion;
  using diagnostics = Diagnostics;
};

/// Nothing evolves; for tests of passes.
struct NothingEvolves {
  using evolves = Fields<>;
  std::tuple<> passes(Resolution const&) const { return {}; }
};

template <int Dim>
struct Bed {
  Points<Dim> material, wall;
};

/// Material fills the box from the origin to `size`; four rows of wall particles below it and at its sides rise eight
/// rows above it.
template <int Dim>
Bed<Dim> open_bed(Vec<Dim, double> const& size, double spacing) {
  Box<Dim> const inner{Vec<Dim, double>::Zero(), size};
  auto open = inner, outer = inner;
  open.high[Dim - 1] += 9 * spacing;
  outer.low.array() -= 4 * spacing;
  outer.high.array() += 4 * spacing;
  outer.high[Dim - 1] = size[Dim - 1] + 8 * spacing;
  return {fill_lattice(inner, spacing), fill_between(open, outer, spacing)};
}

/// A bed in the plane that is periodic in the first direction, over a flat floor.
inline Bed<2> layer(Vec<2, double> const& size, double spacing) {
  return {fill_lattice(Box<2>{{0, 0}, size}, spacing), fill_lattice(Box<2>{{0, -4 * spacing}, {size[0], 0}}, spacing)};
}

template <class P>
Solver<P> solver_of(Bed<P::dim> const& bed, double spacing, typename P::physics const& physics = {},
                    typename P::motion const& motion = {}, std::vector<Period> const& periods = {}) {
  using real = typename P::real;
  SolverSettings<P> settings;
  settings.spacing = spacing;
  settings.physics = physics;
  settings.motion = motion;
  settings.periods = periods;
  return Solver<P>(settings, cast<real>(bed.material), cast<real>(bed.wall));
}

/// Sets a field of the material from a function of the position, in double.
template <class S, Field F, class Function>
void set_field(S& solver, F field, Function const& function) {
  using real = typename S::policy::real;
  solver.set(field, [&](auto const& x) { return real(function(x.template cast<double>().eval())); });
}

/// The rates of the concentration for the present state.
template <class S>
std::vector<double> rates_of(S& solver) {
  solver.update_rates();
  auto const rates = solver.material().to_host(fields::concentration_rate);
  return {rates.begin(), rates.end()};
}
template <class S>
std::vector<double> concentrations_of(S const& solver) {
  auto const C = solver.material().to_host(fields::concentration);
  return {C.begin(), C.end()};
}

inline double sum_of(std::vector<double> const& values) {
  double sum = 0;
  for (double const value : values) sum += value;
  return sum;
}
/// The largest magnitude; infinite if a value is NaN.
inline double largest_of(std::vector<double> const& values) {
  double found = 0;
  for (double const value : values) {
    if (std::isnan(value)) return std::numeric_limits<double>::infinity();
    found = std::max(found, std::abs(value));
  }
  return found;
}

/// Distance of concentrations from [0, 1]; infinite if one is NaN.
inline double outside_of_range(std::vector<double> const& C) {
  double found = 0;
  for (double const value : C) {
    if (std::isnan(value)) return std::numeric_limits<double>::infinity();
    found = std::max({found, -value, value - 1});
  }
  return found;
}

}  // namespace scree::test
