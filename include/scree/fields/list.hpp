// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "field.hpp"

#include <type_traits>

// Set operations on lists of fields. Lists are short; the order of first appearance is preserved.
namespace scree {
namespace detail {

template <class F, class List>
inline constexpr bool contains = false;
template <class F, class... Fs>
inline constexpr bool contains<F, Fields<Fs...>> = (std::is_same_v<F, Fs> || ...);

template <class T>
inline constexpr bool is_list_of_fields = false;
template <class... Fs>
inline constexpr bool is_list_of_fields<Fields<Fs...>> = true;

template <class A, class B>
struct merge_two;
template <class... As>
struct merge_two<Fields<As...>, Fields<>> {
  using type = Fields<As...>;
};
template <class... As, class B, class... Bs>
struct merge_two<Fields<As...>, Fields<B, Bs...>> {
  using extended = std::conditional_t<contains<B, Fields<As...>>, Fields<As...>, Fields<As..., B>>;
  using type = typename merge_two<extended, Fields<Bs...>>::type;
};

template <class A, class B>
inline constexpr bool intersects = false;
template <class... As, class B>
inline constexpr bool intersects<Fields<As...>, B> = (contains<As, B> || ...);

template <class... Lists>
struct merge {
  using type = Fields<>;
};
template <class A>
struct merge<A> {
  using type = typename merge_two<Fields<>, A>::type;
};
template <class A, class B, class... Rest>
struct merge<A, B, Rest...> {
  using type = typename merge<typename merge_two<A, B>::type, Rest...>::type;
};

template <class Kept, class A, class B>
struct subtract;
template <class... Ks, class B>
struct subtract<Fields<Ks...>, Fields<>, B> {
  using type = Fields<Ks...>;
};
template <class... Ks, class A, class... As, class B>
struct subtract<Fields<Ks...>, Fields<A, As...>, B> {
  using kept = std::conditional_t<contains<A, B>, Fields<Ks...>, Fields<Ks..., A>>;
  using type = typename subtract<kept, Fields<As...>, B>::type;
};

// The member lists of a model default to an empty list, so that a model declares only the lists that it uses.
#define SCREE_OPTIONAL_LIST(list)         \
  template <class T>                      \
  struct list##_or_none {                 \
    using type = Fields<>;                \
  };                                      \
  template <class T>                      \
  requires requires { typename T::list; } \
  struct list##_or_none<T> {              \
    using type = typename T::list;        \
  };
SCREE_OPTIONAL_LIST(reads)
SCREE_OPTIONAL_LIST(reads_i)
SCREE_OPTIONAL_LIST(reads_j)
SCREE_OPTIONAL_LIST(adds)
SCREE_OPTIONAL_LIST(writes)
SCREE_OPTIONAL_LIST(provides)
#undef SCREE_OPTIONAL_LIST

}  // namespace detail

/// Whether a field is in a list of fields.
template <class F, class List>
concept OneOf = detail::contains<F, List>;

/// The union of lists.
template <class... Lists>
using Merge = typename detail::merge<Lists...>::type;

/// The fields of A that are not in B.
template <class A, class B>
using Without = typename detail::subtract<Fields<>, A, B>::type;

/// The fields of A that are also in B.
template <class A, class B>
using Common = Without<A, Without<A, B>>;

/// The fields that a model reads from both particles of a pair, or from its only particle: its list `reads`, or an
/// empty list.
template <class T>
using reads_of = typename detail::reads_or_none<T>::type;
/// The fields that a term or lens reads only from particle i: its list `reads_i`, or an empty list.
template <class T>
using reads_i_of = typename detail::reads_i_or_none<T>::type;
/// The fields that a term reads only from particle j: its list `reads_j`, or an empty list.
template <class T>
using reads_j_of = typename detail::reads_j_or_none<T>::type;
/// The fields to which a term adds: its list `adds`, or an empty list.
template <class T>
using adds_of = typename detail::adds_or_none<T>::type;
/// The fields that a point function writes: its list `writes`, or an empty list.
template <class T>
using writes_of = typename detail::writes_or_none<T>::type;
/// The fields of particle j that a lens replaces: its list `provides`, or an empty list.
template <class T>
using provides_of = typename detail::provides_or_none<T>::type;

}  // namespace scree
