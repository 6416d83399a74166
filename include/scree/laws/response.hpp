// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "law.hpp"
#include "matsuoka_nakai.hpp"

#include <stdexcept>
#include <string>
#include <type_traits>

namespace scree::detail {

/// Throws std::invalid_argument unless a value of a law is above 0 and finite.
[[gnu::cold]] void check_of_law(char const* name, double value);
/// Throws std::invalid_argument if a stress (Pa) or stress rate (Pa/s) of a compressed material has no positive
/// pressure or is not finite.
[[gnu::cold]] void check_answer(AnyStress const& answer, char const* function, double trial, char const* what);
/// Throws std::invalid_argument if the stress (Pa) of a law that is declared cohesionless is tensile, for instance
/// because the law derives from a cohesionless one and adds cohesion.
[[gnu::cold]] void check_no_tension(AnyStress const& answer, double trial);

/// Whether a point at rest without history is a complete state for a law, which is so if the law has no history and
/// reads no field other than the shear rate.
template <class Law>
inline constexpr bool is_known_at_rest = std::is_same_v<typename Law::history, Fields<>>&&
    std::is_same_v<Without<typename Law::reads, Fields<ShearRate>>, Fields<>>;

/// Throws std::invalid_argument if the density, the bulk modulus or the speed of sound of a law of constant stiffness
/// is not above 0, or if the law does not resist compression: at strains of 1e-6 and 1e-3 the pressure must be
/// positive, and it must grow under further compression. A law that is declared cohesionless must not bear tension. For
/// laws that have a history or read fields other than the shear rate, the resistance is not checked.
template <class Law>
[[gnu::cold]] void check_response(Law const& law) {
  if constexpr (GivesDensity<Law>) check_of_law("density() (kg/m^3) of the law", law.density());
  if constexpr (ConstantStiffness<Law>) {
    double const K = law.bulk_modulus();
    check_of_law("bulk_modulus() (Pa) of the law", K);
    check_of_law("sound_speed() (m/s) of the law", law.sound_speed());
    if constexpr (is_known_at_rest<Law>) {
      PointOf<Law> const point{};
      MemoryOf<Law> memory{};
      AnyStress const unit = identity_matrix<AnyStress>();
      for (double const strain : {1e-6, 1e-3}) {
        AnyStress const trial = -strain * K * unit, squeezing = -unit / 3;
        check_answer(law.admissible(trial, point, memory), "admissible()", strain * K, "the pressure (Pa)");
        if constexpr (Cohesionless<Law>) check_no_tension(law.admissible(-trial, point, memory), strain * K);
        check_answer(law.stress_rate(trial, squeezing, point), "stress_rate()", strain * K,
                     "the pressure (Pa) per unit of compression");
      }
    }
  }
}

/// Throws std::invalid_argument if a law is declared to take a section but has the same strength in triaxial
/// compression and extension, for instance because it derives from a law that takes a section and replaces its
/// admissible(). A law that has no strength at a point whose fields are all zero passes the check.
template <TakesSection Law>
[[gnu::cold]] void check_section(Law const& law) {
  using Point = PointOf<Law>;
  Point const point{};
  auto const strength = [&](double way) {
    AnyStress trial = -AnyStress(identity_matrix<AnyStress>());
    for (int a = 0; a < 3; ++a) trial(a, a) += way * (a == 2 ? -200 : 100);  // beyond any friction, at p = 1
    MemoryOf<Law> memory{};
    return equivalent_shear_stress(
        deviator_of(law.admissible(trial, PointOfSection<Point, MatsuokaNakai>{point}, memory)));
  };
  double const compressed = strength(1), extended = strength(-1);
  if (extended > 1e-3 && compressed <= extended * (1 + 1e-9))
    throw std::invalid_argument(
        "scree: `takes_section` of the law is true, but admissible() gives the same strength in compression and in "
        "extension of one axis; it calls return_to_yield(trial, k, point), or the law sets `takes_section` to false");
}

}  // namespace scree::detail

#ifndef SCREE_COMPILED
#include "response.ipp"
#endif
