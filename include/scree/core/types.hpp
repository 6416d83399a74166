// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "algebra.hpp"

#include <Kokkos_Core.hpp>

namespace scree {

/// A vector of Dim numbers.
template <int Dim, class Real>
using Vec = Small<Real, Dim, 1>;
/// A square matrix of Dim x Dim numbers.
template <int Dim, class Real>
using Mat = Small<Real, Dim, Dim>;

/// Returns x^2.
template <class T>
SCREE_FN constexpr T sq(T x) {
  return x * x;
}

namespace math {
/// Returns x^N, computed by repeated multiplication.
template <int N, class T>
SCREE_FN constexpr T power(T x) {
  if constexpr (N == 0) return T(1);
  if constexpr (N == 1) return x;
  if constexpr (N > 1) return sq(power<N / 2>(x)) * power<N % 2>(x);
}
}  // namespace math

namespace detail {
/// The type of the numbers in a value: `Scalar` for a vector or matrix, and the type itself for a number.
template <class T>
struct number_of {
  using type = T;
};
template <class T>
requires requires { typename T::Scalar; }
struct number_of<T> {
  using type = typename T::Scalar;
};
}  // namespace detail

/// The number of independent entries of a symmetric tensor of second order.
template <int Dim>
inline constexpr int symmetric_size = Dim*(Dim + 1) / 2;

}  // namespace scree
