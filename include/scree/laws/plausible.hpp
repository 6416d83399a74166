// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "law.hpp"
#include "relative_density.hpp"
#include "well_posedness.hpp"

#include <algorithm>
#include <string>

// Parameters of laws that are in range and yet hardly meant: densities in g/cm^3, an I0 in percent, a modulus in MPa.
namespace scree {
namespace detail {

/// Throws std::invalid_argument if a bed is denser than the grains of a model (densities in kg/m^3).
[[gnu::cold]] void check_density_of_bed(double bed, double grains, char const* model);

/// Returns the warning about a bed of a depth (m) whose weight compresses its bottom by a tenth or more under gravity
/// (m/s^2), with the speed of sound (m/s; 0: unknown); empty for other beds.
[[gnu::cold]] std::string warning_of_soft_bed(double depth, double gravity, double sound_speed);

/// The parameters of a law that doubts_of_law() checks.
struct NumbersOfLaw {
  double density = 0;        ///< least density of a bed, kg/m^3; 0: unknown
  double grain_density = 0;  ///< density of the grains, kg/m^3; 0: unknown
  double I0 = 0, rise = 0;   ///< I0, and rise of the friction from rest to an inertial number of 1
  double cohesion = 0;       ///< cohesion of a cone, Pa
  double young = 0;          ///< Young's modulus, Pa; 0: unknown
};
/// Returns the warnings about the parameters of a law under gravity (m/s^2), one per line; empty if there are none.
[[gnu::cold]] std::string doubts_of(NumbersOfLaw const& law, double gravity);

template <class Law>
concept HasI0 = FrictionOfInertialNumber<Law> && requires(Law const& law) {
  double(law.I0 + law.mu_s);
};

template <class Law>
concept HasConeAndYoung = requires(Law const& law) {
  double(law.cone.cohesion + law.elastic.young);
};

}  // namespace detail

/// Returns warnings, one per line, about densities, an I0 or a cohesion of a law that are in range but hardly meant,
/// under gravity (m/s^2); empty if there are none. For a law by group, those of the first group that has any.
template <class Law>
[[gnu::cold]] std::string doubts_of_law(Law const& law, double gravity) {
  std::string text;
  if constexpr (requires { law.of(law.groups()); }) {
    for (int k = 0; k < law.groups() && text.empty(); ++k) text = doubts_of_law(law.of(k), gravity);
  } else {
    detail::NumbersOfLaw numbers;
    if constexpr (detail::GivesDensity<Law>) numbers.density = law.density();
    if constexpr (DensityOfMixture<Law>) numbers.density = law.densities.minCoeff();
    if constexpr (detail::HasI0<Law>) {
      numbers.grain_density = law.grain_density, numbers.I0 = law.I0;
      // A shear rate against which lambda is nothing, of grains of 1 m.
      numbers.rise = double(law.friction(law.grain_density * 1e18, 1e9, 1.0)) - law.mu_s;
    }
    if constexpr (detail::HasConeAndYoung<Law>) numbers.cohesion = law.cone.cohesion, numbers.young = law.elastic.young;
    text = detail::doubts_of(numbers, gravity);
  }
  return text;
}

}  // namespace scree

#ifndef SCREE_COMPILED
#include "plausible.ipp"
#endif
