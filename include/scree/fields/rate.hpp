// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"
#include "remainder.hpp"

namespace scree {

/// An entry of a list `evolves` that gives the field F a rate other than its own, such as Evolves<Position,
/// TransportVelocity> for positions that move with a smoothed velocity.
template <Field F, Field Rate>
struct Evolves : F {
  using rate = Rate;
};

namespace detail {

// An entry of a list `evolves` is a field, or a field together with its rate.
template <class Entry>
struct evolution {
  using field = Entry;
};
template <class F, class Rate>
struct evolution<Evolves<F, Rate>> {
  using field = F;
};
template <class Entry>
using evolved_field = typename evolution<Entry>::field;

// A field without a rate is a history variable of a projection; each stage starts from its value at the beginning of
// the step.
template <class Entry>
concept HasRate = requires {
  typename Entry::rate;
};
/// Whether an entry has a function `static change(step, i)` that returns the change of its value, because its values
/// are not vectors but, for example, rotations.
template <class Entry>
concept HasOwnChange = requires {
  requires Entry::has_own_change;
};
template <class Entry, class Real, class I>
SCREE_FN auto change(Real step, I&& i) {
  if constexpr (HasOwnChange<Entry>)
    return Entry::change(step, i);
  else if constexpr (HasRate<Entry>)
    return std::remove_cvref_t<decltype(i[typename Entry::rate{}])>(step * i[typename Entry::rate{}]);
  else
    return Real(0);
}
/// The type of a time that multiplies the rates of a list: double if the first field is in double precision, and the
/// precision of the formulation otherwise.
template <class P, class List>
struct time_for {
  using type = typename P::real;
};
template <class P, class First, class... Entries>
requires std::is_same_v < typename number_of<value_t<P, evolved_field<First>>>::type,
double > struct time_for<P, Fields<First, Entries...>> { using type = double; };

template <class Entry>
struct rate_of {
  using type = Fields<>;
};
template <HasRate Entry>
struct rate_of<Entry> {
  using type = Fields<typename Entry::rate>;
};

template <class P, class Entry>
using remainder_of = std::conditional_t<HasRate<Entry> && is_compensated<P, evolved_field<Entry>>,
                                        Fields<Remainder<evolved_field<Entry>>>, Fields<>>;
template <class P, class List>
struct remainders_of_entries;
template <class P, class... Entries>
struct remainders_of_entries<P, Fields<Entries...>> {
  using type = Merge<remainder_of<P, Entries>...>;
};

template <class List>
struct evolution_of;
template <class... Entries>
struct evolution_of<Fields<Entries...>> {
  using fields = Fields<evolved_field<Entries>...>;
  using rates = Merge<typename rate_of<Entries>::type...>;
};

}  // namespace detail

/// The fields of a list `evolves`.
template <class Evolved>
using evolved_fields = typename detail::evolution_of<Evolved>::fields;
/// The rates of the fields of a list `evolves`.
template <class Evolved>
using rates_of_evolved = typename detail::evolution_of<Evolved>::rates;
/// The remainders of the evolved fields that have a rate and are compensated.
template <class P, class Evolved>
using remainders_of_evolved = typename detail::remainders_of_entries<P, Evolved>::type;

/// Sets the field of an entry of a list `evolves` to `from` + `change`, where `from` is its value at an earlier time.
/// Evolved fields are advanced only here. For a compensated field, `i` holds the remainder at that earlier time.
template <class P, class Entry, class I, class O, class T, class Change>
SCREE_FN void evolve(T const& from, Change const& change, [[maybe_unused]] I const& i, O& out) {
  using F = detail::evolved_field<Entry>;
  if constexpr (OneOf<Remainder<F>, detail::remainder_of<P, Entry>>) {
    auto const sum = detail::compensated_sum(from, i[Remainder<F>{}], change);
    out[F{}] = sum.value;
    out[Remainder<F>{}] = sum.remainder;
  } else {
    out[F{}] = from + change;
  }
}

}  // namespace scree
