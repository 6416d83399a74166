// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "types.hpp"

#include <cmath>
#include <type_traits>
#include <utility>

// Packs use the vector types of GCC and Clang; device compilers cannot compile operations on these types.
#if defined(__GNUC__) && !defined(KOKKOS_ENABLE_CUDA) && !defined(KOKKOS_ENABLE_HIP) && !defined(KOKKOS_ENABLE_SYCL)
#define SCREE_HAS_PACKS
#if defined(__AVX__)
#include <immintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif
#endif

// Packs are SIMD vectors of numbers, with which the terms of a pair loop compute several pairs at once on a CPU.
namespace scree {

/// Whether operator() of a term or a lens, or the functions of a kernel, accept packs in place of numbers. A class
/// declares this by `static constexpr bool takes_packs = true`. Code for packs cannot branch on the numbers of a pair
/// (`if`, `?:`), because the numbers differ between lanes; it uses select(), min(), max(), smaller(), magnitude(),
/// root(), quotient(), ratio() and exp() instead. Code for packs cannot read integer fields of particle j.
template <class T>
inline constexpr bool takes_packs = false;
template <class T>
requires requires { T::takes_packs; }
inline constexpr bool takes_packs<T> = T::takes_packs;

template <class Real, int Size>
class Pack;

namespace detail {
template <class T>
struct NumberIn {
  using type = T;
};
template <class Real, int Size>
struct NumberIn<Pack<Real, Size>> {
  using type = Real;
};
}  // namespace detail

/// The type of the numbers in a pack; for a number, its own type.
template <class T>
using number_in = typename detail::NumberIn<T>::type;

/// Whether the compiler has the vector types that Pack needs.
#ifdef SCREE_HAS_PACKS
inline constexpr bool has_packs = true;

namespace detail {
#if defined(__AVX__)
inline constexpr int bytes_of_pack = 32;
#elif defined(__SSE2__) || defined(__ARM_NEON)
inline constexpr int bytes_of_pack = 16;
#else
inline constexpr int bytes_of_pack = 8;
#endif
}  // namespace detail

/// The number of values that one vector instruction processes, according to the compiler flags (-march). A pack has at
/// most 32 bytes, because rows of neighbours are short.
template <class Real>
inline constexpr int native_lanes = detail::bytes_of_pack / int(sizeof(Real));

/// A SIMD vector whose operations apply to each lane. The number of lanes is a power of two.
template <class Real, int Size = native_lanes<Real>>
class Pack {
  using Lanes [[gnu::vector_size(Size * sizeof(Real))]] = Real;
  using Which = decltype(Lanes{} < Lanes{});

 public:
  static constexpr int size = Size;

  Pack() = default;
  /// Sets all lanes to one number.
  template <class Number>
  requires std::is_arithmetic_v<Number> Pack(Number x) : lanes_(static_cast<Real>(x) - Lanes{}) {}  // -0 - 0 is -0
  /// Returns a pack with value(k) in lane k.
  template <class Value>
  requires std::is_invocable_r_v<Real, Value, int>
  static Pack of(Value const& value) {
    return [&]<int... Lane>(std::integer_sequence<int, Lane...>) { return Pack(Lanes{value(Lane)...}); }
    (std::make_integer_sequence<int, Size>{});
  }

  Real operator[](int lane) const { return lanes_[lane]; }
  /// Returns the sum of the first `count` lanes.
  Real sum(int count) const {
    Real total = 0;
    if (count != size) {
      for (int lane = 0; lane < count; ++lane) total += lanes_[lane];
      return total;
    }
#if defined(__SSE2__)
    if constexpr (std::is_same_v<Real, float> && Size == 4) {  // the same sum with one shuffle
      Lanes const folded = lanes_ + Lanes(_mm_shuffle_ps(lanes_, lanes_, _MM_SHUFFLE(0, 1, 2, 3)));
      return folded[0] + folded[1];
    }
#endif
    Lanes folded = lanes_;
    for (int half = size / 2; half > 0; half /= 2)
      for (int lane = 0; lane < half; ++lane) folded[lane] += folded[2 * half - 1 - lane];
    return folded[0];
  }

  friend Pack operator+(Pack const& a, Pack const& b) { return Pack(a.lanes_ + b.lanes_); }
  friend Pack operator-(Pack const& a, Pack const& b) { return Pack(a.lanes_ - b.lanes_); }
  friend Pack operator*(Pack const& a, Pack const& b) { return Pack(a.lanes_ * b.lanes_); }
  friend Pack operator/(Pack const& a, Pack const& b) { return Pack(a.lanes_ / b.lanes_); }
  friend Pack operator-(Pack const& a) { return Pack(-a.lanes_); }
  Pack& operator+=(Pack const& b) { return *this = *this + b; }
  Pack& operator-=(Pack const& b) { return *this = *this - b; }
  Pack& operator*=(Pack const& b) { return *this = *this * b; }
  Pack& operator/=(Pack const& b) { return *this = *this / b; }

  /// Compares two packs lane by lane. Returns a condition for select(), not for `if`.
  friend Which operator<(Pack const& a, Pack const& b) { return a.lanes_ < b.lanes_; }
  friend Which operator>(Pack const& a, Pack const& b) { return a.lanes_ > b.lanes_; }
  friend Which operator<=(Pack const& a, Pack const& b) { return a.lanes_ <= b.lanes_; }
  friend Which operator>=(Pack const& a, Pack const& b) { return a.lanes_ >= b.lanes_; }
  friend Pack select(Which const& condition, Pack const& a, Pack const& b) {
    return Pack(condition ? a.lanes_ : b.lanes_);
  }

  friend bool any_positive(Pack const& x) {
    for (int lane = 0; lane < size; ++lane)
      if (x[lane] > 0) return true;
    return false;
  }

  // As with numbers, min() and max() return the second argument if either argument is NaN.
  friend Pack min(Pack const& a, Pack const& b) { return select(a < b, a, b); }
  friend Pack max(Pack const& a, Pack const& b) { return select(a > b, a, b); }
  friend Pack exp(Pack const& x) {
    return of([&](int lane) { return std::exp(x[lane]); });
  }
  friend Pack root(Pack const& x) {
#if defined(__AVX__)
    if constexpr (std::is_same_v<Real, double> && Size == 4) return Pack(Lanes(_mm256_sqrt_pd(x.lanes_)));
    if constexpr (std::is_same_v<Real, float> && Size == 8) return Pack(Lanes(_mm256_sqrt_ps(x.lanes_)));
#endif
#if defined(__SSE2__)
    if constexpr (std::is_same_v<Real, double> && Size == 2) return Pack(Lanes(_mm_sqrt_pd(x.lanes_)));
    if constexpr (std::is_same_v<Real, float> && Size == 4) return Pack(Lanes(_mm_sqrt_ps(x.lanes_)));
#endif
    return of([&](int lane) { return std::sqrt(x[lane]); });
  }
  friend Pack smaller(Pack const& x, Pack const& y) { return min(x, y); }
  friend Pack magnitude(Pack const& x) { return max(x, -x); }
  friend Pack quotient(Pack const& x, Pack const& y) { return x / y; }
  friend Pack ratio(Pack const& x, Pack const& y) { return x / y; }

 private:
  explicit Pack(Lanes const& all) : lanes_(all) {}

  Lanes lanes_;
};
#else
inline constexpr bool has_packs = false;

/// A declaration without a definition, for compilers without packs.
template <class Real, int Size = 1>
class Pack;
#endif

}  // namespace scree

#ifdef SCREE_HAS_PACKS
template <class Number, int Size>
struct Eigen::NumTraits<scree::Pack<Number, Size>> : Eigen::GenericNumTraits<scree::Pack<Number, Size>> {
  enum { IsSigned = 1, RequireInitialization = 0 };
};
#endif
