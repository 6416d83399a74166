// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <Eigen/Core>
#include <Kokkos_Core.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

/// Marks a function that runs on the host and on the device.
#define SCREE_FN KOKKOS_INLINE_FUNCTION
/// Marks a function that is called inside a pair loop, on the host or on the device, and forces its inlining, because
/// compilers stop inlining in large loops.
#define SCREE_LOOP_FN KOKKOS_FORCEINLINE_FUNCTION

// Arithmetic for small vectors and matrices. In namespace scree, these operators take precedence over Eigen's, whose
// expression templates would account for most of the compile time and gain nothing for so few numbers. Eigen provides
// all other operations (blocks, comparisons, inverses).
namespace scree {

/// A small matrix. It is not aligned (DontAlign), so that its layout does not depend on the compiler flags of a
/// translation unit.
template <class Real, int Rows, int Cols>
using Small = Eigen::Matrix<Real, Rows, Cols, Eigen::DontAlign>;

namespace detail {

/// Whether an Eigen type refers to other objects instead of holding numbers.
template <class T>
inline constexpr bool is_expression = false;
template <class T>
requires std::is_base_of_v<Eigen::EigenBase<T>, T>
inline constexpr bool is_expression<T> = !std::is_base_of_v<Eigen::PlainObjectBase<T>, T>;

/// Whether a scalar of type Number may multiply or divide a matrix of Real: Real itself, an integer or, if Real is a
/// pack, a number that converts to Real.
template <class Number, class Real>
concept FactorOf = std::is_same_v<Number, Real> || std::is_integral_v<Number> ||
    (std::is_arithmetic_v<Number> && !std::is_arithmetic_v<Real> && std::is_convertible_v<Number, Real>);

/// Arithmetic on the entries of small matrices, unrolled explicitly because compilers unroll loops too late to keep the
/// numbers in registers.
template <class Indices>
struct Entries;
template <std::size_t... K>
struct Entries<std::index_sequence<K...>> {
  template <class Matrix>
  SCREE_LOOP_FN static void add(Matrix& a, Matrix const& b) {
    ((a.data()[K] += b.data()[K]), ...);
  }
  template <class Matrix>
  SCREE_LOOP_FN static void subtract(Matrix& a, Matrix const& b) {
    ((a.data()[K] -= b.data()[K]), ...);
  }
  template <class Matrix, class Real>
  SCREE_LOOP_FN static void multiply(Matrix& a, Real const& factor) {
    ((a.data()[K] *= factor), ...);
  }
  template <class Matrix, class Real>
  SCREE_LOOP_FN static void divide(Matrix& a, Real const& divisor) {
    ((a.data()[K] /= divisor), ...);
  }
  template <class Matrix>
  SCREE_LOOP_FN static void negate(Matrix& a) {
    ((a.data()[K] = -a.data()[K]), ...);
  }
  template <class Real>
  SCREE_LOOP_FN static void fill(Real* a, Real const& value) {
    ((a[K] = value), ...);
  }
  template <class Real>
  SCREE_LOOP_FN static void copy(Real* a, Real const* b) {
    ((a[K] = b[K]), ...);
  }
  /// Returns the sum of the products of every `StepA`-th number of a and every `StepB`-th number of b.
  template <std::size_t StepA, std::size_t StepB, class Real>
  SCREE_LOOP_FN static Real dot(Real const* a, Real const* b) {
    return (... + (a[K * StepA] * b[K * StepB]));
  }
  template <std::size_t Step, class Real>
  SCREE_LOOP_FN static Real sum(Real const* a) {
    return (... + a[K * Step]);
  }
  template <std::size_t Rows, std::size_t Inner, class Real>
  SCREE_LOOP_FN static void product(Real* c, Real const* a, Real const* b) {
    using Terms = Entries<std::make_index_sequence<Inner>>;
    ((c[K] = Terms::template dot<Rows, 1>(a + K % Rows, b + K / Rows * Inner)), ...);
  }
  template <std::size_t Rows, class Real>
  SCREE_LOOP_FN static void outer(Real* c, Real const* a, Real const* b) {
    ((c[K] = a[K % Rows] * b[K / Rows]), ...);
  }
  template <std::size_t Rows, std::size_t Cols, class Real>
  SCREE_LOOP_FN static void transpose(Real* c, Real const* a) {
    ((c[K] = a[K % Cols * Rows + K / Cols]), ...);
  }
};
template <int Size>
using EntriesOf = Entries<std::make_index_sequence<std::size_t(Size)>>;

}  // namespace detail

template <class Real, int Rows, int Cols>
SCREE_LOOP_FN Small<Real, Rows, Cols>& operator+=(Small<Real, Rows, Cols>& a, Small<Real, Rows, Cols> const& b) {
  detail::EntriesOf<Rows * Cols>::add(a, b);
  return a;
}
template <class Real, int Rows, int Cols>
SCREE_LOOP_FN Small<Real, Rows, Cols>& operator-=(Small<Real, Rows, Cols>& a, Small<Real, Rows, Cols> const& b) {
  detail::EntriesOf<Rows * Cols>::subtract(a, b);
  return a;
}
template <class Real, int Rows, int Cols, detail::FactorOf<Real> Number>
SCREE_LOOP_FN Small<Real, Rows, Cols>& operator*=(Small<Real, Rows, Cols>& a, Number const& factor) {
  detail::EntriesOf<Rows * Cols>::multiply(a, Real(factor));
  return a;
}
template <class Real, int Rows, int Cols, detail::FactorOf<Real> Number>
SCREE_LOOP_FN Small<Real, Rows, Cols>& operator/=(Small<Real, Rows, Cols>& a, Number const& divisor) {
  detail::EntriesOf<Rows * Cols>::divide(a, Real(divisor));
  return a;
}

template <class Real, int Rows, int Cols>
SCREE_LOOP_FN Small<Real, Rows, Cols> operator+(Small<Real, Rows, Cols> a, Small<Real, Rows, Cols> const& b) {
  return a += b;
}
template <class Real, int Rows, int Cols>
SCREE_LOOP_FN Small<Real, Rows, Cols> operator-(Small<Real, Rows, Cols> a, Small<Real, Rows, Cols> const& b) {
  return a -= b;
}
template <class Real, int Rows, int Cols>
SCREE_LOOP_FN Small<Real, Rows, Cols> operator-(Small<Real, Rows, Cols> a) {
  detail::EntriesOf<Rows * Cols>::negate(a);
  return a;
}
template <class Real, int Rows, int Cols, detail::FactorOf<Real> Number>
SCREE_LOOP_FN Small<Real, Rows, Cols> operator*(Small<Real, Rows, Cols> a, Number const& factor) {
  return a *= factor;
}
template <class Real, int Rows, int Cols, detail::FactorOf<Real> Number>
SCREE_LOOP_FN Small<Real, Rows, Cols> operator*(Number const& factor, Small<Real, Rows, Cols> a) {
  return a *= factor;
}
template <class Real, int Rows, int Cols, detail::FactorOf<Real> Number>
SCREE_LOOP_FN Small<Real, Rows, Cols> operator/(Small<Real, Rows, Cols> a, Number const& divisor) {
  return a /= divisor;
}
/// Returns the matrix product of a and b.
template <class Real, int Rows, int Inner, int Cols>
SCREE_LOOP_FN Small<Real, Rows, Cols> operator*(Small<Real, Rows, Inner> const& a, Small<Real, Inner, Cols> const& b) {
  Small<Real, Rows, Cols> c;
  detail::EntriesOf<Rows * Cols>::template product<Rows, Inner>(c.data(), a.data(), b.data());
  return c;
}

/// Returns the dot product $a \cdot b$ of two vectors, or the double contraction $a : b$ of two matrices.
template <class Real, int Rows, int Cols>
SCREE_LOOP_FN Real dot(Small<Real, Rows, Cols> const& a, Small<Real, Rows, Cols> const& b) {
  return detail::EntriesOf<Rows * Cols>::template dot<1, 1>(a.data(), b.data());
}
/// Returns $\lvert a\rvert^2$ for a vector, or the square of the Frobenius norm for a matrix.
template <class Real, int Rows, int Cols>
SCREE_LOOP_FN Real squared_norm(Small<Real, Rows, Cols> const& a) {
  return dot(a, a);
}
/// Returns the norm $\lvert a\rvert$ of a vector, or the Frobenius norm of a matrix.
template <class Real, int Rows, int Cols>
SCREE_LOOP_FN Real norm(Small<Real, Rows, Cols> const& a) {
  return Kokkos::sqrt(squared_norm(a));
}
/// Returns the outer product $a \otimes b$.
template <class Real, int Rows, int Cols>
SCREE_LOOP_FN Small<Real, Rows, Cols> outer(Small<Real, Rows, 1> const& a, Small<Real, Cols, 1> const& b) {
  Small<Real, Rows, Cols> c;
  detail::EntriesOf<Rows * Cols>::template outer<Rows>(c.data(), a.data(), b.data());
  return c;
}
/// Returns the cross product $a \times b$.
template <class Real>
SCREE_LOOP_FN Small<Real, 3, 1> cross(Small<Real, 3, 1> const& a, Small<Real, 3, 1> const& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// Returns the transpose of a matrix.
template <class Real, int Rows, int Cols>
SCREE_LOOP_FN Small<Real, Cols, Rows> transposed(Small<Real, Rows, Cols> const& a) {
  Small<Real, Cols, Rows> c;
  detail::EntriesOf<Rows * Cols>::template transpose<Rows, Cols>(c.data(), a.data());
  return c;
}
/// Returns the sum of the diagonal entries of a matrix.
template <class Real, int Dim>
SCREE_LOOP_FN Real trace(Small<Real, Dim, Dim> const& a) {
  return detail::EntriesOf<Dim>::template sum<Dim + 1>(a.data());
}
/// Returns a vector that consists of a number followed by the components of another vector.
template <class Real, int Size>
SCREE_LOOP_FN Small<Real, Size + 1, 1> joined(Real const& first, Small<Real, Size, 1> const& rest) {
  Small<Real, Size + 1, 1> all;
  all.data()[0] = first;
  detail::EntriesOf<Size>::copy(all.data() + 1, rest.data());
  return all;
}

/// Returns the zero of a number type or of a small matrix type.
template <class T>
SCREE_LOOP_FN T zero() {
  if constexpr (requires { typename T::Scalar; }) {
    T all;
    detail::EntriesOf<T::SizeAtCompileTime>::fill(all.data(), typename T::Scalar(0));
    return all;
  } else {
    return T(0);
  }
}
/// Returns the identity matrix of a square matrix type.
template <class Matrix>
SCREE_LOOP_FN Matrix identity_matrix() {
  Matrix unit = zero<Matrix>();
  for (int k = 0; k < Matrix::RowsAtCompileTime; ++k) unit(k, k) = typename Matrix::Scalar(1);
  return unit;
}

}  // namespace scree
