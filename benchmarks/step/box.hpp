// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "step_rows.hpp"

#include <scree/granular/segregating.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/laws/grains.hpp>
#include <scree/segregation/shear_rate_closure.hpp>
#include <scree/segregation/size_ratio_closure.hpp>
#include <scree/segregation/species_segregation.hpp>
#include <scree/setup/geostatic.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

// A box of grains that slosh under gravity, open above: one metre wide and deep, sheared at the start.
namespace scree::bench {

struct Controlled : GranularModels {
  using volume_control = VolumeConsistency;
  using walls = AdamiWalls;
};
struct ControlledMixture : Controlled {
  using law = MuOfI<BidisperseGrains>;
};
template <int Dim, class Real>
struct GranularBox : Formulation<Dim, Real> {
  using physics = Granular<Controlled>;
};
/// All models by default but the walls and the strain.
template <class Scheme, class Strain>
struct DefaultsWith : GranularModels {
  using walls = Scheme;
  using strain = Strain;
};
template <int Dim, class Real, class Scheme, class Strain = PlainStrain>
struct DefaultBox : Formulation<Dim, Real> {
  using physics = Granular<DefaultsWith<Scheme, Strain>>;
};
template <int Dim, class Real>
struct SegregatingBox : Formulation<Dim, Real> {
  using mechanics = Granular<ControlledMixture>;
  using physics = SegregatingGranular<mechanics, ConservativeSegregation<ShearRateClosure>>;
};

template <int N>
struct ControlledSpecies : Controlled {
  using law = MuOfI<PolydisperseGrains<N>>;
};
/// A box that segregates N sizes of grains.
template <int Dim, class Real, int N>
struct SpeciesBox : Formulation<Dim, Real> {
  static constexpr int species = N;
  using mechanics = Granular<ControlledSpecies<N>>;
  using physics = Combined<mechanics, SpeciesSegregation<SizeRatioClosure<N>>>;
};

/// The variant with the least memory: cells at each update instead of lists, and no fields of the previous step.
template <class F>
struct ListFree : F {
  template <class P>
  using search = CellList<P>;
  using integrator = SymplecticEuler;
};

inline Elastic stiff_bed() { return {.young = 1e6, .poisson = 0.3, .rest_density = 1500}; }  // waves of 30 m/s

template <class F>
typename F::physics physics_of() {
  typename F::physics physics;
  if constexpr (requires { F::species; }) {
    Vec<F::species, double> sizes;
    for (int k = 0; k < F::species; ++k) sizes[k] = 1e-3 * (1 + k / (F::species - 1.0));
    physics.mechanics.law = MuOfI<PolydisperseGrains<F::species>>{.elastic = stiff_bed(), .grains = {sizes}};
    physics.transport.closure.diameters = sizes;
  } else if constexpr (requires { physics.mechanics; }) {
    physics.mechanics.law = ControlledMixture::law{.elastic = stiff_bed(), .grains = {1e-3, 2e-3}};
    physics.transport.closure.d_small = 1e-3;
    physics.transport.closure.d_large = 2e-3;
  } else {
    physics.law = Controlled::law{.elastic = stiff_bed(), .grains = {1e-3}};
  }
  return physics;
}

/// A box one metre wide and deep, and `length` of these along x, with about `particles` of the material and three rows
/// of wall around them.
struct BoxCase {
  double particles;
  double shear = 0.5;  // 1/s
  double length = 1;   // m
};

template <class Points>
struct BoxPoints {
  double spacing;
  Points inside, wall;
};
/// `share`: that of one rank of the case; none: all points.
template <int Dim, class... OfWhom>
auto points_of(BoxCase const& wanted, OfWhom const&... share) {
  double const spacing = 1 / std::round(std::pow(wanted.particles / wanted.length, 1.0 / Dim));
  auto const ones = Vec<Dim, double>::Ones();
  Box<Dim> inside{Vec<Dim, double>::Zero(), ones};
  inside.high[0] = wanted.length;
  auto open = inside, outside = inside;
  outside.low -= 3 * spacing * ones;
  outside.high += 3 * spacing * ones;
  open.high = outside.high;
  for (int axis = 0; axis + 1 < Dim; ++axis) open.high[axis] = inside.high[axis];
  using Points = decltype(fill_lattice(inside, spacing, share...));
  return BoxPoints<Points>{spacing, fill_lattice(inside, spacing, share...),
                           fill_between(open, outside, spacing, share...)};
}

/// Stress of a bed at rest, sheared, with uneven concentration if there is any.
template <class F>
void start(Solver<F>& solver, BoxCase const& wanted) {
  using namespace fields;
  using Real = typename F::real;
  using vector = Vec<F::dim, Real>;
  Geostatic const bed{1, stiff_bed().density(), Gravity().magnitude, 1};
  solver.set(stress, [&](vector const& x) { return packed<F::dim>(Mat<3, Real>(bed(x).template cast<Real>())); });
  solver.set(velocity, [&](vector const& x) {
    vector u = vector::Zero();
    u[0] = Real(wanted.shear) * x[F::dim - 1];
    return u;
  });
  if constexpr (OneOf<Concentration, material_fields<F>>)
    solver.set(concentration, [](vector const& x) { return Real(0.5) + Real(0.4) * Kokkos::sin(20 * x[0]); });
  if constexpr (requires { F::species; })
    solver.set(concentrations<F::species>, [](vector const& x) {
      Vec<F::species, Real> C = Vec<F::species, Real>::Constant(Real(1) / F::species);
      Real const more = Real(0.8) / F::species * Kokkos::sin(20 * x[0]);
      C[0] += more, C[1] -= more;
      return C;
    });
}

/// `share`: that of one rank of the case, which begins with it; none: it begins whole.
template <class F, class... OfWhom>
Solver<F> box(BoxCase const& wanted, typename F::space const& space = {},
              decltype(SolverSettings<F>::ranks) const& ranks = {}, OfWhom const&... share) {
  using Real = typename F::real;
  auto const points = points_of<F::dim>(wanted, share...);
  SolverSettings<F> const settings{.spacing = points.spacing, .physics = physics_of<F>(), .ranks = ranks};
  auto solver = [&] {
    if constexpr (sizeof...(share) > 0)
      return Solver<F>(space, settings, points.inside, points.wall);
    else
      return Solver<F>(space, settings, cast<Real>(points.inside), cast<Real>(points.wall));
  }();
  start(solver, wanted);
  return solver;
}

template <class F>
int add_box_rows(std::string const& physics) {
  int const period = LinearFilter().period;  // so that each timed part contains one filter
  for (int const particles : sizes<F>()) {
    auto const name = [&](char const* what) {
      return fmt::format("step/{}/{}/{}/particles:{}", physics, what, basis_name<F>(), particles);
    };
    auto const make = [=] { return box<F>({.particles = double(particles)}); };
    add_step_row(name("library"), period, period, make);
    add_phases_row(name("phases"), period, make);
  }
  return 0;
}

}  // namespace scree::bench
