// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "types.hpp"

// Roots, quotients and extremes of pair loops. In single precision a GPU has one instruction for the inverse root,
// right to two units in the last place, and builds correctly rounded roots and quotients of a dozen. The sums over
// pairs are good to a few units either way.
namespace scree {

/// Square root of x >= 0.
SCREE_LOOP_FN double root(double x) { return Kokkos::sqrt(x); }
SCREE_LOOP_FN float root(float x) {
  KOKKOS_IF_ON_DEVICE((return x > 0 ? x * Kokkos::rsqrt(x) : 0;))
  KOKKOS_IF_ON_HOST((return Kokkos::sqrt(x);))
}

/// The smaller and the larger one, for those who must not write `if`, see pack.hpp; y if one is not a number.
SCREE_LOOP_FN double min(double x, double y) { return x < y ? x : y; }
SCREE_LOOP_FN float min(float x, float y) { return x < y ? x : y; }
SCREE_LOOP_FN double max(double x, double y) { return x > y ? x : y; }
SCREE_LOOP_FN float max(float x, float y) { return x > y ? x : y; }

/// x/y, y > 0.
SCREE_LOOP_FN double quotient(double x, double y) { return x / y; }
SCREE_LOOP_FN float quotient(float x, float y) {
  KOKKOS_IF_ON_DEVICE((float const inverse_root = Kokkos::rsqrt(y); return x * inverse_root * inverse_root;))
  KOKKOS_IF_ON_HOST((return x / y;))
}

}  // namespace scree
