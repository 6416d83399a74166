// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "step_rows.hpp"

#include <scree/granular/granular.hpp>
#include <scree/laws/drucker_prager.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

// The benchmark of LOQUAT, an SPH code for soil on a GPU (Peng et al. 2019): a block of dry soil that collapses onto a
// plane between walls. As in LOQUAT: h = 1.5 spacings, three dummy layers that extrapolate, midpoint
// predictor-corrector, no filters, timed over steps 40 to 240.
namespace scree::bench {

struct LoquatModels : GranularModels {
  using law = DruckerPrager;
  using filter = NoFilter;
  using walls = AdamiWalls;
};
template <class Real>
struct Loquat : Formulation<3, Real> {
  using physics = Granular<LoquatModels>;
};

inline Granular<LoquatModels> loquat_physics() {
  double const K = 5e6, G = 2.30769e6, rho = 1850;  // Pa, kg/m^3
  DruckerPrager const law{
      .elastic = {.young = 9 * K * G / (3 * K + G), .poisson = (3 * K - 2 * G) / (6 * K + 2 * G), .rest_density = rho},
      .cone = {.friction = 0.494872}};
  double const sound_speed = std::sqrt(K / rho);  // LOQUAT's, without the shear modulus
  return {.law = law, .viscosity_speed = 0.25 * sound_speed, .cfl = 0.2 * law.sound_speed() / sound_speed};
}

/// s scales the number of particles along each axis: 40 s x 40 s x 18 s of the material.
template <class Real>
Solver<Loquat<Real>> loquat(int s) {
  double const spacing = 0.05 / s, cell = 0.05;
  auto const cells = [=](double x, double y, double z) { return Vec<3, double>(x * cell, y * cell, z * cell); };
  auto const rows = [=] { return Vec<3, double>::Constant(3 * spacing); }();
  Box<3> const basin{cells(0, 0, 0), cells(120, 40, 20)};
  Box<3> outside{basin.low - rows, basin.high + rows};
  outside.high[2] = basin.high[2];
  return Solver<Loquat<Real>>({.spacing = spacing, .physics = loquat_physics()},
                              cast<Real>(fill_lattice(Box<3>{cells(0, 0, 0), cells(40, 40, 18)}, spacing)),
                              cast<Real>(fill_between(basin, outside, spacing)));
}

template <class Real>
int add_loquat_rows() {
  for (int const s : {1, 3, 6}) {
    if (s > 1 && !on_gpu) continue;
    auto const name = fmt::format("step/loquat/library/{}/s:{}", basis_name<Loquat<Real>>(), s);
    add_step_row(name, 40, 200, [=] { return loquat<Real>(s); })->Iterations(200);
    add_phases_row(fmt::format("step/loquat/phases/{}/s:{}", basis_name<Loquat<Real>>(), s), 40,
                   [=] { return loquat<Real>(s); });
  }
  return 0;
}

}  // namespace scree::bench
