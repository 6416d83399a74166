// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "kernel.hpp"

#include <numbers>

namespace scree {

/// The Gaussian $\exp(-q^2)$, cut off at q = 3, where it is 1.2e-4 of its maximum, and normalised on q < 3: Gingold &
/// Monaghan (1977), MNRAS 181, 375.
struct Gaussian {
  static constexpr double support = 3;
  static constexpr bool takes_packs = true;
  template <class T>
  SCREE_FN static T w(T q) {
    using Kokkos::exp;
    return exp(-q * q);
  }
  template <class T>
  SCREE_FN static T dw_over_q(T q) {
    using Kokkos::exp;
    return -2 * exp(-q * q);
  }
  // The integral of exp(-q^2) over q < 3 in one, two and three dimensions: sqrt(pi) erf(3), pi (1 - exp(-9)), pi
  // (sqrt(pi) erf(3) - 6 exp(-9)).
  static constexpr double root_pi = 1.7724538509055159, erf_3 = 0.99997790950300136, exp_9 = 1.2340980408667956e-4;
  template <int Dim>
  static constexpr double sigma() {
    using std::numbers::pi;
    return detail::by_dimension<Dim>(1 / (root_pi * erf_3), 1 / (pi * (1 - exp_9)),
                                     1 / (pi * (root_pi * erf_3 - 6 * exp_9)));
  }
};

}  // namespace scree
