// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "law.hpp"
#include "matsuoka_nakai.hpp"

#include <stdexcept>
#include <string>
#include <type_traits>

namespace scree::detail {

/// Throws std::invalid_argument unless a number of a law is above 0 and finite.
[[gnu::cold]] void check_of_law(char const* name, double value);
/// Throws std::invalid_argument for a stress (Pa), or a rate of it (Pa/s), of a compressed material that bears nothing.
[[gnu::cold]] void check_answer(AnyStress const& answer, char const* function, double trial, char const* what);
/// Throws std::invalid_argument for the stress (Pa) of a cohesionless law that keeps a tension, for instance because it
/// derives from a law without cohesion and adds some.
[[gnu::cold]] void check_no_tension(AnyStress const& answer, double trial);

/// Whether a point without history, at rest, is a complete state for a law: values of other fields that it reads are
/// not known here.
template <class Law>
inline constexpr bool is_known_at_rest = std::is_same_v<typename Law::history, Fields<>>&&
    std::is_same_v<Without<typename Law::reads, Fields<ShearRate>>, Fields<>>;

/// Throws std::invalid_argument for a law of constant stiffness whose density or moduli are not above 0, or that does
/// not resist: compressed by 1e-6 and by 1e-3, its stress must keep a pressure, and grow when it is compressed further.
/// A law that says that it has no cohesion must not keep a tension. Only density and moduli are checked for laws that
/// read more than the shear rate or have a history.
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

/// Throws std::invalid_argument for a law that says that it takes a section and has the same strength in compression
/// and extension of one axis, for instance because it derives from a law that takes one and replaces its admissible().
/// A law whose strength is not known at a point of zeros passes.
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
