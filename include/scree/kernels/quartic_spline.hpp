// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/root.hpp"
#include "kernel.hpp"

#include <numbers>

namespace scree {

/// The quartic M5 spline on q < 5/2: Morris (1996), PhD thesis, Monash University.
struct QuarticSpline {
  static constexpr double support = 2.5;
  static constexpr bool takes_packs = true;
  template <class T>
  SCREE_FN static T w(T q) {
    using namespace math;
    T const outside = power<4>(T(2.5) - q) - 5 * power<4>(max(T(0), T(1.5) - q));
    return select(q < T(0.5), (6 * q * q - 15) * q * q + T(115) / 8, outside);
  }
  template <class T>
  SCREE_FN static T dw_over_q(T q) {
    using namespace math;
    T const outside = (20 * power<3>(max(T(0), T(1.5) - q)) - 4 * power<3>(T(2.5) - q)) / q;
    return select(q < T(0.5), 24 * q * q - 30, outside);
  }
  template <int Dim>
  static constexpr double sigma() {
    using std::numbers::pi;
    return detail::by_dimension<Dim>(1.0 / 24, 96 / (1199 * pi), 1 / (20 * pi));
  }
};

}  // namespace scree
