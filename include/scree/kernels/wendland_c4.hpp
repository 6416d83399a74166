// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "kernel.hpp"

#include <numbers>

namespace scree {

/// The Wendland C4 kernel $(1 - q/2)^6 (35/12 q^2 + 3 q + 1)$ on q < 2: Wendland (1995), Adv. Comput. Math. 4, 389.
struct WendlandC4 {
  static constexpr double support = 2;
  static constexpr bool takes_packs = true;
  template <class T>
  SCREE_FN static T w(T q) {
    return math::power<6>(1 - q / 2) * ((T(35) / 12 * q + 3) * q + 1);
  }
  template <class T>
  SCREE_FN static T dw_over_q(T q) {
    return -T(14) / 3 * math::power<5>(1 - q / 2) * (T(5) / 2 * q + 1);
  }
  template <int Dim>
  static constexpr double sigma() {
    using std::numbers::pi;
    return detail::by_dimension<Dim>(27.0 / 32, 9 / (4 * pi), 495 / (256 * pi));
  }
};

}  // namespace scree
