// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "types.hpp"

// Square roots, divisions, minima, maxima and selections for pair loops. In single precision, a GPU has one instruction
// for the inverse square root, accurate to two units in the last place, but needs about a dozen instructions for a
// correctly rounded square root or division. Sums over pairs are accurate to a few units in the last place in either
// case.
//
// Code that calls these functions must first declare `using namespace math;`, because a qualified call does not find
// the overloads for packs (pack.hpp).
namespace scree {
namespace math {

/// Returns the square root of x >= 0. NaN stays NaN, so that an invalid position shows up in the sums.
SCREE_LOOP_FN double root(double x) { return Kokkos::sqrt(x); }
SCREE_LOOP_FN float root(float x) {
  KOKKOS_IF_ON_DEVICE((return x == 0 ? 0 : x * Kokkos::rsqrt(x);))
  KOKKOS_IF_ON_HOST((return Kokkos::sqrt(x);))
}

/// Returns x if the condition holds, and y otherwise, for code without branches (see pack.hpp). Both x and y are
/// evaluated.
SCREE_LOOP_FN double select(bool condition, double x, double y) { return condition ? x : y; }
SCREE_LOOP_FN float select(bool condition, float x, float y) { return condition ? x : y; }

/// Returns the smaller of two numbers, or y if either is NaN.
SCREE_LOOP_FN double min(double x, double y) { return x < y ? x : y; }
SCREE_LOOP_FN float min(float x, float y) { return x < y ? x : y; }
/// Returns the larger of two numbers, or y if either is NaN.
SCREE_LOOP_FN double max(double x, double y) { return x > y ? x : y; }
SCREE_LOOP_FN float max(float x, float y) { return x > y ? x : y; }

/// Returns the smaller of two numbers, with one instruction on a GPU, or y if x is NaN.
SCREE_LOOP_FN double smaller(double x, double y) {
  KOKKOS_IF_ON_DEVICE((return Kokkos::fmin(x, y);))
  KOKKOS_IF_ON_HOST((return x < y ? x : y;))
}
SCREE_LOOP_FN float smaller(float x, float y) {
  KOKKOS_IF_ON_DEVICE((return Kokkos::fmin(x, y);))
  KOKKOS_IF_ON_HOST((return x < y ? x : y;))
}

/// Returns |x|.
SCREE_LOOP_FN double magnitude(double x) { return Kokkos::abs(x); }
SCREE_LOOP_FN float magnitude(float x) { return Kokkos::abs(x); }

/// Whether x > 0 or, for a pack, whether any lane is positive. Callers use the result to skip code that adds nothing if
/// x is 0.
SCREE_LOOP_FN bool any_positive(double x) { return x > 0; }
SCREE_LOOP_FN bool any_positive(float x) { return x > 0; }

/// Returns x/y for y > 0.
SCREE_LOOP_FN double quotient(double x, double y) { return x / y; }
SCREE_LOOP_FN float quotient(float x, float y) {
  KOKKOS_IF_ON_DEVICE((float const inverse_root = Kokkos::rsqrt(y); return x * inverse_root * inverse_root;))
  KOKKOS_IF_ON_HOST((return x / y;))
}

/// Returns x/y for numbers of either sign, and 0 if y is infinite.
SCREE_LOOP_FN double ratio(double x, double y) { return x / y; }
SCREE_LOOP_FN float ratio(float x, float y) {
#ifdef __CUDA_ARCH__
  float inverse;
  asm("rcp.approx.ftz.f32 %0, %1;" : "=f"(inverse) : "f"(y));
  return x * inverse;
#else
  return x / y;
#endif
}

}  // namespace math

/// Whether a division costs more than a branch that avoids it, as in double precision on a GPU. The value is true only
/// for double: in single precision the division is fast, and packs cannot branch.
template <class Real>
inline constexpr bool quotient_is_slow = std::is_same_v<Real, double>;

}  // namespace scree
