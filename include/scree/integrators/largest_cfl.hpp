// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"

#include <string>

namespace scree {

/// Returns the largest `cfl` of granular mechanics, the time step over h/c_s, that an integrator allows. The value is
/// the member `largest_cfl` of the integrator or, without this member, 1 for staggered integrators such as
/// SymplecticEuler and 0.3 for others such as Midpoint.
template <class Integrator>
constexpr double largest_cfl() {
  if constexpr (requires { double(Integrator::largest_cfl); })
    return Integrator::largest_cfl;
  else if constexpr (requires { requires bool(Integrator::staggered); })
    return 1;
  else
    return 0.3;
}

namespace detail {

/// Throws std::invalid_argument if the cfl is above the largest one that an integrator allows. Physics models without
/// `acoustic_cfl()` have no cfl to check.
[[gnu::cold]] inline void check_cfl(double cfl, double largest, std::string const& integrator) {
  check_setting(
      cfl <= largest, "cfl (-)", cfl,
      formatted("at most %g with the integrator%s, whose steps make elastic waves grow above it (`largest_cfl` "
                "of the integrator)",
                largest, integrator.c_str())
          .c_str());
}
template <class Integrator, class Physics>
void check_cfl_of(Physics const& physics) {
  if constexpr (requires { physics.acoustic_cfl(); }) {
    std::string name;
    if constexpr (requires { std::string(Integrator::name); }) name = " ", name += Integrator::name;
    check_cfl(physics.acoustic_cfl(), largest_cfl<Integrator>(), name);
  }
}

}  // namespace detail
}  // namespace scree
