// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "list.hpp"

// Values of some fields of one particle, held in registers.
namespace scree {
namespace detail {

/// A basis with which concepts check models that do not depend on a basis.
struct AnyPoint {
  static constexpr int dim = 3;
  using real = double;
};
/// A field that no model names.
struct AnyField : Scalar<"any field", "1"> {};

/// Returns a stand-in for a missing value, so that the compiler reports only the mistake itself. The function is never
/// defined.
template <class T>
T& missing();

template <class P, class F>
struct Slot {
  value_t<P, F> value;
};

/// A sum to which a term can only add, so that a term can neither overwrite nor read the contribution of another term.
template <class T>
class Sum {
 public:
  Sum() = default;
  Sum(Sum const&) = default;
  Sum& operator=(Sum const&) = delete;
  template <class X>
  SCREE_LOOP_FN Sum& operator+=(X const& x) {
    value_ += x;
    return *this;
  }
  SCREE_FN T const& result() const { return value_; }

 private:
  T value_ = zero<T>();
};
template <class P, class F>
struct SumSlot {
  Sum<value_t<P, F>> sum;
};

}  // namespace detail

/// The values of a particle that a kernel has read, as in `i[velocity]`.
template <class P, class List>
struct Record;
template <class P, class... Fs>
struct Record<P, Fields<Fs...>> : detail::Slot<P, Fs>... {
  template <Field F>
  SCREE_FN auto const& operator[](F) const {
    constexpr bool declared = OneOf<F, Fields<Fs...>>;
    static_assert(declared, "this model reads a field that it does not declare in `reads`");
    if constexpr (declared)
      return static_cast<detail::Slot<P, F> const&>(*this).value;
    else
      return detail::missing<value_t<P, F> const>();
  }
  SCREE_FN Record& operator+=(Record const& other) {
    ((static_cast<detail::Slot<P, Fs>&>(*this).value += other[Fs{}]), ...);
    return *this;
  }
};

/// The values that a point function returns, as in `out[shear_rate] = ...`.
template <class P, class List>
struct Results;
template <class P, class... Fs>
struct Results<P, Fields<Fs...>> : detail::Slot<P, Fs>... {
  template <Field F>
  using type = value_t<P, F>;
  template <Field F>
  SCREE_FN auto& operator[](F) {
    constexpr bool declared = OneOf<F, Fields<Fs...>>;
    static_assert(declared, "this model writes a field that it does not declare in `writes`");
    if constexpr (declared)
      return static_cast<detail::Slot<P, F>&>(*this).value;
    else
      return detail::missing<value_t<P, F>>();
  }
};

/// The sums to which a pair term adds; `sum[acceleration] += ...` is the only operation.
template <class P, class List>
struct Sums;
template <class P, class... Fs>
struct Sums<P, Fields<Fs...>> : detail::SumSlot<P, Fs>... {
  template <Field F>
  SCREE_FN auto& operator[](F) {
    constexpr bool declared = OneOf<F, Fields<Fs...>>;
    static_assert(declared, "this term adds to a field that it does not declare in `adds`");
    if constexpr (declared)
      return static_cast<detail::SumSlot<P, F>&>(*this).sum;
    else
      return detail::missing<detail::Sum<value_t<P, F>>>();
  }
  SCREE_FN Record<P, Fields<Fs...>> totals() const {
    return {{static_cast<detail::SumSlot<P, Fs> const&>(*this).sum.result()}...};
  }
};

}  // namespace scree
