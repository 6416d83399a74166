// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"

namespace scree {

/// Acts against the last coordinate, which is up, or is turned from there towards the first one, for slopes.
struct Gravity {
  double magnitude = 9.81;  ///< m/s^2
  double inclination = 0;   ///< rad

  template <class X>
  SCREE_FN X vector() const {
    X g = zero<X>();
    g[0] = magnitude * Kokkos::sin(inclination);
    g[X::RowsAtCompileTime - 1] = -magnitude * Kokkos::cos(inclination);
    return g;
  }
};

}  // namespace scree
