// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "pair.hpp"

#include "../fields/record.hpp"

#include <concepts>
#include <type_traits>

namespace scree {
namespace detail {
template <class T>
using record_i = Merge<reads_of<T>, reads_i_of<T>>;
template <class T>
using record_j = Merge<reads_of<T>, reads_j_of<T>>;
}  // namespace detail

/// Whether T is a term, a sum over neighbours $\sum_j f(i, j)$. A term lists the fields that it reads from both
/// particles (`reads`), the fields that it reads from i or j alone (`reads_i`, `reads_j`, both optional) and the fields
/// that it adds to (`adds`), and has
///   operator()(i, j, ij, sum)   with records i and j, the Pair ij, and sums that offer only +=.
/// `static constexpr bool includes_self = true` requests the pair of a particle with itself, at r = 0; takes_packs =
/// true declares that the term accepts several pairs at once (core/pack.hpp); is_long = true declares that a pair takes
/// hundreds of operations, so that a loop without packs, as on a GPU, finds all neighbours of a particle before it adds
/// their terms.
template <class T, class P>
concept PairTerm = requires {
  typename T::reads;
  typename T::adds;
}
&&requires(T const& term, Record<P, detail::record_i<T>> const& i, Record<P, detail::record_j<T>> const& j,
           Pair<P> const& ij, Sums<P, adds_of<T>>& sum) {
  term(i, j, ij, sum);
};

/// Whether a term requests the pair of a particle with itself.
template <class T>
inline constexpr bool includes_self = false;
template <class T>
requires requires { T::includes_self; }
inline constexpr bool includes_self<T> = T::includes_self;

/// Whether a term declares that a pair takes hundreds of operations.
template <class T>
inline constexpr bool is_long = false;
template <class T>
requires requires { T::is_long; }
inline constexpr bool is_long<T> = T::is_long;

/// Whether T is a function of a single particle, with lists `reads` and `writes` and operator()(i, out).
template <class T, class P>
concept PointFunction = requires {
  typename T::reads;
  typename T::writes;
}
&&requires(T const& function, Record<P, reads_of<T>> const& i, Results<P, writes_of<T>>& out) { function(i, out); };

/// Whether T is a condition on a particle, the `where` of a pass, with a list `reads` and operator()(i), which returns
/// a bool.
template <class T, class P>
concept ParticleCondition = requires(T const& condition, Record<P, reads_of<T>> const& i) {
  typename T::reads;
  { condition(i) } -> std::convertible_to<bool>;
};
/// The condition that holds for all particles.
struct Everywhere {
  using reads = Fields<>;
  template <class I>
  SCREE_FN bool operator()(I const&) const {
    return true;
  }
};

/// Whether T is a function of a particle and its sums, the `then` of a pair pass. The function has lists `reads` (of
/// particle i) and `writes`, and operator()(i, total, out). A pass with such a function does not store the sums.
template <class T, class P, class Adds>
concept FunctionOfSums = requires {
  typename T::reads;
  typename T::writes;
}
&&requires(T const& function, Record<P, reads_of<T>> const& i, Record<P, Adds> const& total,
           Results<P, writes_of<T>>& out) {
  function(i, total, out);
};
/// The `then` of a pass that stores its sums.
struct StoreSums {};
/// Whether a pass with this `then` stores its sums.
template <class Then>
inline constexpr bool stores_sums = std::is_same_v<Then, StoreSums>;

/// The lens that changes nothing. A lens replaces values of particle j for a given particle i. It has one overload
/// operator()(Field, i, j) for each field in `provides`, and for no other field; all other values are j's own. `reads`
/// and `reads_i` list the fields that the lens needs from j and from i in addition to those of the terms; `takes_packs`
/// has the same meaning as for terms.
struct AsIs {
  static constexpr bool takes_packs = true;
  using provides = Fields<>;
};

}  // namespace scree
