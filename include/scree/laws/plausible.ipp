// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "../core/setting.hpp"
#include "plausible.hpp"

#include <cmath>

namespace scree::detail {

SCREE_BODY void check_density_of_bed(double bed, double grains, char const* model) {
  check_setting(
      bed <= grains, "rest_density (kg/m^3) of the law", bed,
      formatted("at most the grain_density of %s, %.6g kg/m^3 (a bed has pores and is lighter than its grains; set "
                "grain_density for heavier grains)",
                model, grains)
          .c_str());
}

SCREE_BODY std::string warning_of_soft_bed(double depth, double gravity, double sound_speed) {
  double const c = sound_speed, compression = gravity * depth / (c * c);
  if (!(c > 0 && compression > 0.1)) return "";
  return formatted(
      "scree: warning: the weight of a bed of %.4g m compresses the material by %.2g %% at its bottom, where its speed "
      "of sound is %.4g m/s: 12 sqrt(g H), %.4g m/s, or more is recommended; check the units of stiffness (Pa) and "
      "density (kg/m^3)",
      depth, 100 * compression, c, 12 * std::sqrt(gravity * depth));
}

SCREE_BODY std::string doubts_of(NumbersOfLaw const& law, double gravity) {
  std::string text;
  // Only under the gravity of the earth in m/s^2: other units, also none, have other numbers for both. The lightest
  // grains, beads of foam, make beds of 10 kg/m^3.
  if (law.density > 0 && law.density < 5 && gravity > 9.7 && gravity < 9.9)
    text += formatted(
        "\nscree: warning: the density of the material is %.6g kg/m^3, lighter than any bed of grains (10 and more): "
        "is it given in g/cm^3?",
        law.density);
  else if (law.rise > 0 && law.density > 0 && law.density < 0.005 * law.grain_density)
    text += formatted(
        "\nscree: warning: the grains fill only %.2g %% of the bed, whose density is %.6g kg/m^3 with a grain_density "
        "of %.6g kg/m^3: the inertial number follows from the latter",
        100 * law.density / law.grain_density, law.density, law.grain_density);
  // Fits to experiments and simulations have an I0 of 0.05 to 1; a large one with a large mu_d makes a friction that
  // rises in proportion to I, by about 1.
  if (law.I0 > 2 && law.rise > 0 && law.rise < 0.1)
    text += formatted(
        "\nscree: warning: with an I0 of %.6g the friction has risen by only %.2g at an inertial number of 1, which "
        "dense flows do not reach: I0 of grains is 0.05 to 1; if the friction is meant to be constant, set mu_d to "
        "mu_s",
        law.I0, law.rise);
  // Soil has a modulus of 50 times its cohesion and more; some gels have one of the same size.
  if (law.young > 0 && law.cohesion > law.young)
    text += formatted(
        "\nscree: warning: the cohesion of the cone, %.6g Pa, is above Young's modulus, %.6g Pa: the material would "
        "double its length before it yields; are both given in Pa?",
        law.cohesion, law.young);
  return text.empty() ? text : text.substr(1);
}

}  // namespace scree::detail
