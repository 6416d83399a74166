// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "list.hpp"

#include <type_traits>

// Remainders of evolved quantities whose steps are smaller than the last digit. In single precision, x += dt u leaves x
// unchanged if dt u is less than half a unit in the last place of x; a larger dt u is rounded to whole units. At x = 1
// m and dt = 3e-6 s, particles with a speed of 20 mm/s move 1.9 times as fast, and slower particles do not move at all.
namespace scree {

/// The rounding error of the value of a field F, at most half a unit in the last place of the value. The quantity that
/// evolves is value + remainder. Integrators store the remainder (`is_compensated`); code that only reads F can ignore
/// it.
template <Field F>
struct Remainder {
  static constexpr std::string_view name = F::name;
  static constexpr std::string_view unit = F::unit;
  template <int Dim, class Real>
  using value = typename F::template value<Dim, Real>;
};

namespace detail {
template <class F>
concept MayBeCompensated = requires {
  requires F::compensated;
};
}  // namespace detail

/// Whether a field evolves together with its remainder: in single precision, if its declaration has
/// `static constexpr bool compensated = true`.
template <class P, class F>
inline constexpr bool is_compensated = detail::MayBeCompensated<F>&& std::is_same_v<typename P::real, float>;

namespace detail {
template <class P, class List>
struct remainders;
template <class P, class... Fs>
struct remainders<P, Fields<Fs...>> {
  using type = Merge<std::conditional_t<is_compensated<P, Fs>, Fields<Remainder<Fs>>, Fields<>>...>;
};
}  // namespace detail

/// The remainders of the fields of a list that evolve with a remainder.
template <class P, class List>
using remainders_of = typename detail::remainders<P, List>::type;

namespace detail {

template <class T>
struct Compensated {
  T value, remainder;
};

/// Returns a + b and its rounding error, which is exact (Moeller 1965). The computation has no products, so that
/// contraction to fused multiply-adds changes nothing.
template <class Real>
SCREE_LOOP_FN Compensated<Real> two_sum(Real const& a, Real const& b) {
  Real const sum = a + b, of_b = sum - a, of_a = sum - of_b;
  return {sum, (a - of_a) + (b - of_b)};
}
/// Returns value + remainder + change as a value and a remainder. The error is at most one unit in the last place of
/// the remainder.
template <class T>
SCREE_LOOP_FN Compensated<T> compensated_sum(T const& value, T const& remainder, T const& change) {
  T const by = remainder + change;
  if constexpr (requires { typename T::Scalar; }) {
    Compensated<T> result;
    for (int k = 0; k < T::SizeAtCompileTime; ++k) {
      auto const [sum, error] = two_sum(value.data()[k], by.data()[k]);
      result.value.data()[k] = sum, result.remainder.data()[k] = error;
    }
    return result;
  } else {
    return two_sum(value, by);
  }
}

}  // namespace detail
}  // namespace scree
