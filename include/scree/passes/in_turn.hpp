// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/record.hpp"

namespace scree {
namespace detail {

/// A particle with new values for some fields.
template <class P, class Written, class I>
struct Updated {
  Record<P, Written> fresh;
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

/// Two functions of one particle fused into one sweep. The second function reads the values that the first has written;
/// the first may also be a function of the sums of a pair loop.
template <class P, class First, class Second>
struct InTurn {
  First first;
  Second second;
  using reads = Merge<reads_of<First>, Without<reads_of<Second>, writes_of<First>>>;
  using writes = Merge<writes_of<First>, writes_of<Second>>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    first(i, out);
    second(updated(i, out, writes_of<First>{}), out);
  }
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& i, T const& total, O& out) const {
    first(i, total, out);
    second(updated(i, out, writes_of<First>{}), out);
  }

 private:
  template <class I, class O, class... Fs>
  SCREE_FN static detail::Updated<P, Fields<Fs...>, I> updated(I const& i, O& out, Fields<Fs...>) {
    return {{{out[Fs{}]}...}, i};
  }
};

/// Returns one function that calls the given functions one after another; a single function is returned unchanged.
template <class P, class First>
First in_turn(First const& first) {
  return first;
}
template <class P, class First, class Second, class... Others>
auto in_turn(First const& first, Second const& second, Others const&... others) {
  return in_turn<P>(InTurn<P, First, Second>{first, second}, others...);
}

}  // namespace scree
