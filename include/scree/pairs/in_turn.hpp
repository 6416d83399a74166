// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/record.hpp"

namespace scree {
namespace detail {

/// A particle of which some fields have new values.
template <class Written, class New, class I>
struct Updated {
  New const& fresh;
  I const& i;
  template <Field F>
  SCREE_FN auto const& operator[](F field) const {
    if constexpr (OneOf<F, Written>)
      return fresh[field];
    else
      return i[field];
  }
};

}  // namespace detail

/// Two functions of one particle as one, in one sweep: the second finds what the first wrote.
template <class P, class First, class Second>
struct InTurn {
  First first;
  Second second;
  using reads = Merge<reads_of<First>, Without<reads_of<Second>, writes_of<First>>>;
  using writes = Merge<writes_of<First>, writes_of<Second>>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    first(i, out);
    auto const fresh = written(out, writes_of<First>{});
    second(detail::Updated<writes_of<First>, std::remove_cvref_t<decltype(fresh)>, I>{fresh, i}, out);
  }

 private:
  template <class O, class... Fs>
  SCREE_FN static Record<P, Fields<Fs...>> written(O& out, Fields<Fs...>) {
    return {{out[Fs{}]}...};
  }
};

/// One function of many; of one, itself.
template <class P, class First>
First in_turn(First const& first) {
  return first;
}
template <class P, class First, class Second, class... Others>
auto in_turn(First const& first, Second const& second, Others const&... others) {
  return in_turn<P>(InTurn<P, First, Second>{first, second}, others...);
}

}  // namespace scree
