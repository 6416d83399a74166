// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "packing.hpp"

#include <scree/granular/granular.hpp>
#include <scree/setup/geostatic.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

#include <cmath>
#include <numbers>

// Shared by the verification cases of the granular solver.
namespace scree::test {

inline double const g = 9.81, bed_density = 1500, poisson = 0.3;  // m/s^2, kg/m^3, -

/// The material of Zhu et al. (2024), Table 1, softened to a given speed of compression waves (m/s).
inline MuOfI<> beads(double sound_speed, double diameter = 0.5e-3) {
  double const young =
      bed_density * sq(sound_speed) * (1 + poisson) * (1 - 2 * poisson) / (1 - poisson);  // K + 4G/3 = rho c_s^2
  return {.elastic = {young, poisson, bed_density}, .grains = {diameter}};
}

template <int Dim, class Physics, class Real = double, class Integrator = Midpoint>
struct GranularCase : Formulation<Dim, Real> {
  using physics = Physics;
  using integrator = Integrator;
};

/// Stress in the order of the library from the diagonal of a tensor in axes (along, up, out of the plane).
template <int Dim, class Real>
Vec<symmetric3_size<Dim>, Real> packed_stress(Geostatic const& bed, Vec<Dim, Real> const& x) {
  return packed<Dim>(Mat<3, Real>(bed(x).template cast<Real>()));
}

inline double degrees(double angle) { return angle * std::numbers::pi / 180; }

}  // namespace scree::test
