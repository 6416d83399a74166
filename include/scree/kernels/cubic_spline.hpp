// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/root.hpp"
#include "kernel.hpp"

#include <numbers>

namespace scree {

/// The cubic M4 spline on q < 2: Monaghan & Lattanzio (1985), Astron. Astrophys. 149, 135.
struct CubicSpline {
  static constexpr double support = 2;
  static constexpr bool takes_packs = true;
  template <class T>
  SCREE_FN static T w(T q) {
    using namespace math;
    return select(q < 1, 1 + (T(3) / 4 * q - T(3) / 2) * q * q, power<3>(2 - q) / 4);
  }
  template <class T>
  SCREE_FN static T dw_over_q(T q) {
    using namespace math;
    return select(q < 1, T(9) / 4 * q - 3, -T(3) / 4 * sq(2 - q) / q);
  }
  template <int Dim>
  static constexpr double sigma() {
    using std::numbers::pi;
    return detail::by_dimension<Dim>(2.0 / 3, 10 / (7 * pi), 1 / pi);
  }
};

}  // namespace scree
