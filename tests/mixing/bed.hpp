// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/mixing/doucet.hpp>
#include <scree/mixing/intensity.hpp>
#include <scree/mixing/lacey.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

#include <cstdint>
#include <vector>

// A bed that nothing moves, whose concentrations a test sets.
namespace scree::test::mixing {

struct Settled {
  using evolves = Fields<>;
  std::tuple<> passes(Resolution const&) const { return {}; }
  std::tuple<> limits(Resolution const&) const { return {}; }
};

template <int Dim, class Real = double, class Carried = Fields<Concentration>>
struct MixedBed : Formulation<Dim, Real> {
  using physics = Settled;
  using carries = Carried;
};

/// The unit square or cube, with `rows` particles along its side.
template <int Dim, class Real = double, class Carried = Fields<Concentration>>
Solver<MixedBed<Dim, Real, Carried>> unit_bed(int rows, std::vector<Period> const& periods = {}) {
  using vector = Vec<Dim, double>;
  double const dr = 1.0 / rows;
  auto const points = fill_lattice(Box<Dim>{vector::Zero(), vector::Constant(1)}, dr);
  return Solver<MixedBed<Dim, Real, Carried>>({.spacing = dr, .physics = {}, .periods = periods, .start_checks = false},
                                              cast<Real>(points));
}

/// Numbers from 0 to 1 that have no order: the fractions of multiples of the golden ratio, mixed.
inline double chance(std::uint64_t k) {
  k = (k + 0x9e3779b97f4a7c15u) * 0xbf58476d1ce4e5b9u;
  k = (k ^ (k >> 30)) * 0x94d049bb133111ebu;
  return double((k ^ (k >> 31)) >> 11) / 9007199254740992.0;
}

}  // namespace scree::test::mixing
