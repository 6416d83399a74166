// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/kernels/kernel.hpp>

#include <numbers>

namespace scree::test::archetypes {

/// 1 - q/2 on q < 2, with a bounded slope at 0 in place of its own.
struct Kernel {
  static constexpr double support = 2;
  template <class T>
  SCREE_FN static T w(T q) {
    return 1 - q / 2;
  }
  template <class T>
  SCREE_FN static T dw_over_q(T q) {
    return T(-0.5) / (q > T(0.1) ? q : T(0.1));
  }
  template <int Dim>
  static constexpr double sigma() {
    using std::numbers::pi;
    return detail::by_dimension<Dim>(0.5, 3 / (4 * pi), 3 / (8 * pi));
  }
};
static_assert(SmoothingKernel<Kernel>);

}  // namespace scree::test::archetypes
