// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "types.hpp"

// Roots, quotients, extremes and choices of pair loops. In single precision a GPU has one instruction for the inverse
// root, right to two units in the last place, and builds correctly rounded roots and quotients of a dozen. The sums
// over pairs are good to a few units either way.
namespace scree {

/// Square root of x >= 0. What is not a number stays so, for a position that is not must show in the sums.
SCREE_LOOP_FN double root(double x) { return Kokkos::sqrt(x); }
SCREE_LOOP_FN float root(float x) {
  KOKKOS_IF_ON_DEVICE((return x == 0 ? 0 : x * Kokkos::rsqrt(x);))
  KOKKOS_IF_ON_HOST((return Kokkos::sqrt(x);))
}

/// x where the condition holds, else y: for those who must not write `if`, see pack.hpp. Both are computed.
SCREE_LOOP_FN double select(bool condition, double x, double y) { return condition ? x : y; }
SCREE_LOOP_FN float select(bool condition, float x, float y) { return condition ? x : y; }

/// The smaller and the larger one; y if one is not a number.
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

/// Whether a quotient costs more than the question whether it is needed: in double on a GPU it does, not so in single
/// precision; of packs there is no asking.
template <class Real>
inline constexpr bool quotient_is_slow = std::is_same_v<Real, double>;

}  // namespace scree
