// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/root.hpp"
#include "kernel.hpp"

#include <numbers>

namespace scree {

/// The quintic M6 spline on q < 3: Morris (1996), PhD thesis, Monash University.
struct QuinticSpline {
  static constexpr double support = 3;
  static constexpr bool takes_packs = true;
  template <class T>
  SCREE_FN static T w(T q) {
    using namespace math;
    T const outside = power<5>(3 - q) - 6 * power<5>(max(T(0), 2 - q));
    return select(q < 1, ((30 - 10 * q) * q * q - 60) * q * q + 66, outside);
  }
  template <class T>
  SCREE_FN static T dw_over_q(T q) {
    using namespace math;
    T const outside = (30 * power<4>(max(T(0), 2 - q)) - 5 * power<4>(3 - q)) / q;
    return select(q < 1, (120 - 50 * q) * q * q - 120, outside);
  }
  template <int Dim>
  static constexpr double sigma() {
    using std::numbers::pi;
    return detail::by_dimension<Dim>(1.0 / 120, 7 / (478 * pi), 1 / (120 * pi));
  }
};

}  // namespace scree
