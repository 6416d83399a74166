// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "list.hpp"

// Values of some fields of one particle, in registers.
namespace scree {
namespace detail {

/// The basis in which concepts check models that do not depend on one.
struct AnyPoint {
  static constexpr int dim = 3;
  using real = double;
};
/// A field that no model names.
struct AnyField : Scalar<"any field", "1"> {};

template <class P, class F>
struct Slot {
  value_t<P, F> value;
};

/// A sum can only be added to: a term can neither overwrite nor read another term's contribution.
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

/// The values of a particle that a kernel has read: `i[velocity]`.
template <class P, class List>
struct Record;
template <class P, class... Fs>
struct Record<P, Fields<Fs...>> : detail::Slot<P, Fs>... {
  template <Field F>
  SCREE_FN auto const& operator[](F) const {
    static_assert(OneOf<F, Fields<Fs...>>, "this model reads a field that it does not declare in `reads`");
    return static_cast<detail::Slot<P, F> const&>(*this).value;
  }
  SCREE_FN Record& operator+=(Record const& other) {
    ((static_cast<detail::Slot<P, Fs>&>(*this).value += other[Fs{}]), ...);
    return *this;
  }
};

/// The values that a point function returns: `out[shear_rate] = ...`.
template <class P, class List>
struct Results;
template <class P, class... Fs>
struct Results<P, Fields<Fs...>> : detail::Slot<P, Fs>... {
  template <Field F>
  using type = value_t<P, F>;
  template <Field F>
  SCREE_FN auto& operator[](F) {
    static_assert(OneOf<F, Fields<Fs...>>, "this model writes a field that it does not declare in `writes`");
    return static_cast<detail::Slot<P, F>&>(*this).value;
  }
};

/// The sums that a pair term adds to: `sum[acceleration] += ...` is the only operation.
template <class P, class List>
struct Sums;
template <class P, class... Fs>
struct Sums<P, Fields<Fs...>> : detail::SumSlot<P, Fs>... {
  template <Field F>
  SCREE_FN auto& operator[](F) {
    static_assert(OneOf<F, Fields<Fs...>>, "this term adds to a field that it does not declare in `adds`");
    return static_cast<detail::SumSlot<P, F>&>(*this).sum;
  }
  SCREE_FN Record<P, Fields<Fs...>> totals() const {
    return {{static_cast<detail::SumSlot<P, Fs> const&>(*this).sum.result()}...};
  }
};

}  // namespace scree
