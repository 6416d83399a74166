// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "types.hpp"

#include <algorithm>
#include <cstddef>
#include <type_traits>

// Device compilers cannot compile this header.
#if __has_include(<experimental/simd>) && defined(__GLIBCXX__) && !defined(KOKKOS_ENABLE_CUDA) && \
    !defined(KOKKOS_ENABLE_HIP) && !defined(KOKKOS_ENABLE_SYCL)
#define SCREE_HAS_PACKS
#include <experimental/simd>
#endif

// Packs are SIMD vectors of numbers: with them the terms of a pair loop compute several pairs at once on a CPU.
namespace scree {

/// Whether operator() of a term or a lens, or the functions of a kernel, accept packs in place of numbers; they declare
/// it by `static constexpr bool takes_packs = true`. Such code cannot branch on the numbers of a pair (`if`, `?:`),
/// because they differ between lanes; it uses select(), min(), max(), root(), quotient() and exp() instead. It cannot
/// read integers of j.
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

/// The scalar type of a pack; a number itself.
template <class T>
using number_in = typename detail::NumberIn<T>::type;

#ifdef SCREE_HAS_PACKS
inline constexpr bool has_packs = true;

/// The numbers that one vector instruction of the processor holds, as given by the compiler flags (-march), limited to
/// 32 bytes because rows of neighbours are short.
template <class Real>
inline constexpr int native_lanes = std::min<int>(std::experimental::native_simd<Real>::size(), 32 / sizeof(Real));

/// A SIMD vector: operations apply to each lane.
template <class Real, int Size = native_lanes<Real>>
class Pack {
  using Lanes = std::experimental::simd<Real, std::experimental::simd_abi::deduce_t<Real, Size>>;
  using Which = typename Lanes::mask_type;

 public:
  static constexpr int size = Size;

  Pack() = default;
  /// The same number in all lanes.
  template <class Number>
  requires std::is_arithmetic_v<Number> Pack(Number x) : lanes_(static_cast<Real>(x)) {}
  /// value(k) in lane k.
  template <class Value>
  requires std::is_invocable_r_v<Real, Value, int>
  static Pack of(Value const& value) {
    return Pack(Lanes([&](auto lane) { return value(static_cast<int>(lane)); }));
  }

  Real operator[](int lane) const { return lanes_[static_cast<std::size_t>(lane)]; }
  /// The sum of the first `count` lanes.
  Real sum(int count) const {
    if (count == size) return std::experimental::reduce(lanes_);
    Real total = 0;
    for (int lane = 0; lane < count; ++lane) total += (*this)[lane];
    return total;
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

  /// Lane-wise comparison: a condition for select(), not for `if`.
  friend Which operator<(Pack const& a, Pack const& b) { return a.lanes_ < b.lanes_; }
  friend Which operator>(Pack const& a, Pack const& b) { return a.lanes_ > b.lanes_; }
  friend Which operator<=(Pack const& a, Pack const& b) { return a.lanes_ <= b.lanes_; }
  friend Which operator>=(Pack const& a, Pack const& b) { return a.lanes_ >= b.lanes_; }
  friend Pack select(Which const& condition, Pack const& a, Pack b) {
    where(condition, b.lanes_) = a.lanes_;
    return b;
  }

  // As for numbers: the second argument if one of them is NaN.
  friend Pack min(Pack const& a, Pack const& b) { return select(a < b, a, b); }
  friend Pack max(Pack const& a, Pack const& b) { return select(a > b, a, b); }
  friend Pack exp(Pack const& x) { return Pack(std::experimental::exp(x.lanes_)); }
  friend Pack root(Pack const& x) { return Pack(std::experimental::sqrt(x.lanes_)); }
  friend Pack quotient(Pack const& x, Pack const& y) { return x / y; }

 private:
  explicit Pack(Lanes const& all) : lanes_(all) {}

  Lanes lanes_;
};
#else
inline constexpr bool has_packs = false;

/// An empty declaration for compilers without packs.
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
