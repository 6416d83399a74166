// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <Eigen/Core>
#include <Kokkos_Core.hpp>
#include <type_traits>

// Arithmetic of small vectors and matrices. Code in namespace scree finds these operators before Eigen's, whose
// expression templates take a compiler most of its time and gain nothing on so few numbers. Whatever is not here
// (blocks, comparisons, inverses) is Eigen's.
namespace scree {

/// A small matrix. DontAlign: the layout must not depend on the compiler flags of a translation unit.
template <class Real, int Rows, int Cols>
using Small = Eigen::Matrix<Real, Rows, Cols, Eigen::DontAlign>;

namespace detail {
/// Numbers that a matrix of Real may be multiplied with without losing digits.
template <class Number, class Real>
concept FactorOf = std::is_same_v<Number, Real> || std::is_integral_v<Number> ||
    (std::is_arithmetic_v<Number> && !std::is_arithmetic_v<Real> && std::is_convertible_v<Number, Real>);
}  // namespace detail

template <class Real, int Rows, int Cols>
KOKKOS_FORCEINLINE_FUNCTION Small<Real, Rows, Cols>& operator+=(Small<Real, Rows, Cols>& a,
                                                                Small<Real, Rows, Cols> const& b) {
  for (int k = 0; k < Rows * Cols; ++k) a.data()[k] += b.data()[k];
  return a;
}
template <class Real, int Rows, int Cols>
KOKKOS_FORCEINLINE_FUNCTION Small<Real, Rows, Cols>& operator-=(Small<Real, Rows, Cols>& a,
                                                                Small<Real, Rows, Cols> const& b) {
  for (int k = 0; k < Rows * Cols; ++k) a.data()[k] -= b.data()[k];
  return a;
}
template <class Real, int Rows, int Cols, detail::FactorOf<Real> Number>
KOKKOS_FORCEINLINE_FUNCTION Small<Real, Rows, Cols>& operator*=(Small<Real, Rows, Cols>& a, Number const& factor) {
  for (int k = 0; k < Rows * Cols; ++k) a.data()[k] *= Real(factor);
  return a;
}
template <class Real, int Rows, int Cols, detail::FactorOf<Real> Number>
KOKKOS_FORCEINLINE_FUNCTION Small<Real, Rows, Cols>& operator/=(Small<Real, Rows, Cols>& a, Number const& divisor) {
  for (int k = 0; k < Rows * Cols; ++k) a.data()[k] /= Real(divisor);
  return a;
}

template <class Real, int Rows, int Cols>
KOKKOS_FORCEINLINE_FUNCTION Small<Real, Rows, Cols> operator+(Small<Real, Rows, Cols> const& a,
                                                              Small<Real, Rows, Cols> const& b) {
  Small<Real, Rows, Cols> sum;
  for (int k = 0; k < Rows * Cols; ++k) sum.data()[k] = a.data()[k] + b.data()[k];
  return sum;
}
template <class Real, int Rows, int Cols>
KOKKOS_FORCEINLINE_FUNCTION Small<Real, Rows, Cols> operator-(Small<Real, Rows, Cols> const& a,
                                                              Small<Real, Rows, Cols> const& b) {
  Small<Real, Rows, Cols> difference;
  for (int k = 0; k < Rows * Cols; ++k) difference.data()[k] = a.data()[k] - b.data()[k];
  return difference;
}
template <class Real, int Rows, int Cols>
KOKKOS_FORCEINLINE_FUNCTION Small<Real, Rows, Cols> operator-(Small<Real, Rows, Cols> const& a) {
  Small<Real, Rows, Cols> negative;
  for (int k = 0; k < Rows * Cols; ++k) negative.data()[k] = -a.data()[k];
  return negative;
}
template <class Real, int Rows, int Cols, detail::FactorOf<Real> Number>
KOKKOS_FORCEINLINE_FUNCTION Small<Real, Rows, Cols> operator*(Small<Real, Rows, Cols> const& a, Number const& factor) {
  Small<Real, Rows, Cols> product;
  for (int k = 0; k < Rows * Cols; ++k) product.data()[k] = a.data()[k] * Real(factor);
  return product;
}
template <class Real, int Rows, int Cols, detail::FactorOf<Real> Number>
KOKKOS_FORCEINLINE_FUNCTION Small<Real, Rows, Cols> operator*(Number const& factor, Small<Real, Rows, Cols> const& a) {
  return a * factor;
}
template <class Real, int Rows, int Cols, detail::FactorOf<Real> Number>
KOKKOS_FORCEINLINE_FUNCTION Small<Real, Rows, Cols> operator/(Small<Real, Rows, Cols> const& a, Number const& divisor) {
  Small<Real, Rows, Cols> quotient;
  for (int k = 0; k < Rows * Cols; ++k) quotient.data()[k] = a.data()[k] / Real(divisor);
  return quotient;
}
/// The matrix product.
template <class Real, int Rows, int Inner, int Cols>
KOKKOS_FORCEINLINE_FUNCTION Small<Real, Rows, Cols> operator*(Small<Real, Rows, Inner> const& a,
                                                              Small<Real, Inner, Cols> const& b) {
  Small<Real, Rows, Cols> product;
  for (int col = 0; col < Cols; ++col)
    for (int row = 0; row < Rows; ++row) {
      Real sum = a.data()[row] * b.data()[col * Inner];
      for (int k = 1; k < Inner; ++k) sum += a.data()[row + k * Rows] * b.data()[k + col * Inner];
      product.data()[row + col * Rows] = sum;
    }
  return product;
}

/// a . b, of matrices the double contraction a : b.
template <class Real, int Rows, int Cols>
KOKKOS_FORCEINLINE_FUNCTION Real dot(Small<Real, Rows, Cols> const& a, Small<Real, Rows, Cols> const& b) {
  Real sum = a.data()[0] * b.data()[0];
  for (int k = 1; k < Rows * Cols; ++k) sum += a.data()[k] * b.data()[k];
  return sum;
}
/// |a|^2, of matrices that of Frobenius.
template <class Real, int Rows, int Cols>
KOKKOS_FORCEINLINE_FUNCTION Real squared_norm(Small<Real, Rows, Cols> const& a) {
  return dot(a, a);
}
/// |a|
template <class Real, int Rows, int Cols>
KOKKOS_FORCEINLINE_FUNCTION Real norm(Small<Real, Rows, Cols> const& a) {
  return Kokkos::sqrt(squared_norm(a));
}
/// The outer product a (x) b.
template <class Real, int Rows, int Cols>
KOKKOS_FORCEINLINE_FUNCTION Small<Real, Rows, Cols> outer(Small<Real, Rows, 1> const& a,
                                                          Small<Real, Cols, 1> const& b) {
  Small<Real, Rows, Cols> product;
  for (int col = 0; col < Cols; ++col)
    for (int row = 0; row < Rows; ++row) product.data()[row + col * Rows] = a.data()[row] * b.data()[col];
  return product;
}
/// The vector of a number and then those of another vector.
template <class Real, int Size>
KOKKOS_FORCEINLINE_FUNCTION Small<Real, Size + 1, 1> joined(Real const& first, Small<Real, Size, 1> const& rest) {
  Small<Real, Size + 1, 1> all;
  all.data()[0] = first;
  for (int k = 0; k < Size; ++k) all.data()[k + 1] = rest.data()[k];
  return all;
}
template <class Real, int Rows, int Cols>
KOKKOS_FORCEINLINE_FUNCTION Small<Real, Cols, Rows> transposed(Small<Real, Rows, Cols> const& a) {
  Small<Real, Cols, Rows> result;
  for (int col = 0; col < Cols; ++col)
    for (int row = 0; row < Rows; ++row) result.data()[col + row * Cols] = a.data()[row + col * Rows];
  return result;
}
template <class Real, int Dim>
KOKKOS_FORCEINLINE_FUNCTION Real trace(Small<Real, Dim, Dim> const& a) {
  Real sum = a.data()[0];
  for (int k = 1; k < Dim; ++k) sum += a.data()[k * (Dim + 1)];
  return sum;
}

namespace detail {
template <class T>
struct IsSmall : std::false_type {};
template <class Real, int Rows, int Cols>
struct IsSmall<Small<Real, Rows, Cols>> : std::true_type {};
}  // namespace detail

/// The additive zero of a number or of a small matrix.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION T zero() {
  if constexpr (detail::IsSmall<T>::value) {
    T result;
    for (int k = 0; k < T::SizeAtCompileTime; ++k) result.data()[k] = typename T::Scalar(0);
    return result;
  } else {
    return T(0);
  }
}
/// The unit of a square matrix.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION T identity_matrix() {
  T result = zero<T>();
  for (int k = 0; k < T::RowsAtCompileTime; ++k) result.data()[k * (T::RowsAtCompileTime + 1)] = typename T::Scalar(1);
  return result;
}

}  // namespace scree
