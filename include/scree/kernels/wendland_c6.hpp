// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "kernel.hpp"

#include <numbers>

namespace scree {

/// The Wendland C6 kernel, $(1 - q/2)^8 (4 q^3 + 25/4 q^2 + 4 q + 1)$ on q < 2: Wendland (1995), Advances in
/// Computational Mathematics 4, 389.
struct WendlandC6 {
  static constexpr double support = 2;
  static constexpr bool takes_packs = true;
  template <class T>
  SCREE_FN static T w(T q) {
    return math::power<8>(1 - q / 2) * (((4 * q + T(25) / 4) * q + 4) * q + 1);
  }
  template <class T>
  SCREE_FN static T dw_over_q(T q) {
    return -T(11) / 2 * math::power<7>(1 - q / 2) * ((4 * q + T(7) / 2) * q + 1);
  }
  template <int Dim>
  static constexpr double sigma() {
    using std::numbers::pi;
    return detail::by_dimension<Dim>(15.0 / 16, 39 / (14 * pi), 1365 / (512 * pi));
  }
};

}  // namespace scree
