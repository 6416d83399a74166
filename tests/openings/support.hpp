// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/granular/granular.hpp>
#include <scree/openings/ledger.hpp>
#include <scree/openings/regions.hpp>

#include <support/formulations.hpp>
#include <support/weightless_sand.hpp>

// A block of sand without weight that moves along the first axis, fed at its end.
namespace scree::test {

constexpr double dr = 0.1, speed = 1;  // m, m/s

template <class Q, class Integrator = Midpoint>
struct FedSand : Formulation<Q::dim, typename Q::real> {
  using space = typename Q::space;
  using physics = Granular<>;
  using integrator = Integrator;
  using carries = Fields<Held>;
};
/// From `from` to `to` along the first axis, `rows` spacings across it.
template <int Dim>
Points<Dim> slab(double from, double to, int rows) {
  Vec<Dim, double> low = Vec<Dim, double>::Zero(), high = Vec<Dim, double>::Constant(rows * dr);
  low[0] = from, high[0] = to;
  return fill_lattice(Box<Dim>{low, high}, dr);
}
template <int Dim>
Inlet<Dim> pushing(int rows) {
  return {.layer = slab<Dim>(-dr, 0, rows), .velocity = speed * Vec<Dim, double>::Unit(0)};
}
template <int Dim>
Beyond<Dim> beyond(double x) {
  return {x * Vec<Dim, double>::Unit(0), Vec<Dim, double>::Unit(0)};
}
/// A block 0.8 m long that moves with the speed of the inlet behind it, and a drain beyond 1 m.
template <class F>
Solver<F> fed(int rows = 4) {
  constexpr int dim = F::dim;
  using X = Vec<dim, typename F::real>;
  Solver<F> solver({.spacing = dr, .physics = weightless()}, points_of<F>(slab<dim>(0, 0.8, rows)));
  solver.set(fields::velocity, [](X const&) { return X(typename F::real(speed) * X::Unit(0)); });
  solver.feed(pushing<dim>(rows));
  solver.drain({}, beyond<dim>(1));
  return solver;
}

}  // namespace scree::test
