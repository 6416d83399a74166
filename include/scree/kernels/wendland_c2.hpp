// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "kernel.hpp"

#include <numbers>

namespace scree {

/// The Wendland C2 kernel $(1 - q/2)^4 (2 q + 1)$ on q < 2: Wendland (1995), Adv. Comput. Math. 4, 389. This kernel
/// avoids the pairing instability (Dehnen & Aly 2012). It is the kernel of Zhu et al. (2024), eq. 3.3.
struct WendlandC2 {
  static constexpr double support = 2;
  static constexpr bool takes_packs = true;
  template <class T>
  SCREE_FN static T w(T q) {
    return math::power<4>(1 - q / 2) * (2 * q + 1);
  }
  template <class T>
  SCREE_FN static T dw_over_q(T q) {
    return -5 * math::power<3>(1 - q / 2);
  }
  template <int Dim>
  static constexpr double sigma() {
    using std::numbers::pi;
    return detail::by_dimension<Dim>(3.0 / 4, 7 / (4 * pi), 21 / (16 * pi));
  }
};

}  // namespace scree
