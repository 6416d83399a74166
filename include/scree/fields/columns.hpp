// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "array.hpp"
#include "record.hpp"

// The part of a particle container that is passed to a kernel: one span for each of the named fields.
namespace scree {

/// The values of one field of all particles, as a span for kernels.
template <class P, class F>
using Column = ArraySpan<P, value_t<P, F>>;

namespace detail {
template <class P, class F>
struct ColumnSlot {
  Column<P, F> view;
};
}  // namespace detail

template <class P, class List>
struct Columns;
template <class P, class... Fs>
struct Columns<P, Fields<Fs...>> : detail::ColumnSlot<P, Fs>... {
  template <Field F>
  SCREE_FN Column<P, F> const& operator[](F) const {
    static_assert(OneOf<F, Fields<Fs...>>, "these particles do not carry this field");
    return static_cast<detail::ColumnSlot<P, F> const&>(*this).view;
  }
  template <Field F>
  SCREE_LOOP_FN value_t<P, F> load(F field, int i) const {
    return value_of((*this)[field](i));
  }
  SCREE_FN Record<P, Fields<Fs...>> load([[maybe_unused]] int i) const { return {{load(Fs{}, i)}...}; }
  /// Returns the fields of a particle. Values that are already known are not read again.
  template <class... Gs>
  SCREE_LOOP_FN Record<P, Fields<Fs...>> load(int i, Record<P, Fields<Gs...>> const& known) const {
    return {{known_or_loaded<OneOf<Fs, Fields<Gs...>>>(Fs{}, i, known)}...};
  }
  SCREE_FN void store([[maybe_unused]] int i, Results<P, Fields<Fs...>> const& results) const {
    ((static_cast<detail::ColumnSlot<P, Fs> const&>(*this).view(i) =
          static_cast<detail::Slot<P, Fs> const&>(results).value),
     ...);
  }
  SCREE_FN void store([[maybe_unused]] int i, Record<P, Fields<Fs...>> const& record) const {
    ((static_cast<detail::ColumnSlot<P, Fs> const&>(*this).view(i) = record[Fs{}]), ...);
  }
  template <class... Gs>
  Columns<P, Fields<Gs...>> select(Fields<Gs...>) const {
    return {{(*this)[Gs{}]}...};
  }

 private:
  template <bool IsKnown, Field F, class Known>
  SCREE_LOOP_FN value_t<P, F> known_or_loaded(F field, int i, Known const& known) const {
    if constexpr (IsKnown)
      return known[field];
    else
      return load(field, i);
  }
};

}  // namespace scree
