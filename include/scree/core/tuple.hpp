// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

// Lists of values of several types, such as the terms of a pass and the passes of a step. The library itself stores
// such a list as a Tuple. With std::tuple, a formulation takes a tenth longer to compile, because of conversions,
// assignments and comparisons that no pass needs (docs/performance.md). Models and users make a std::tuple; functions
// of the library accept both types.
namespace scree::detail {

/// One value of a Tuple.
template <std::size_t K, class T>
struct TupleValue {
  T value;
};
template <class Numbers, class... Ts>
struct TupleValues;
template <std::size_t... K, class... Ts>
struct TupleValues<std::index_sequence<K...>, Ts...> : TupleValue<K, Ts>... {};

/// A list of values of given types, in order.
template <class... Ts>
struct Tuple : TupleValues<std::index_sequence_for<Ts...>, Ts...> {
  constexpr Tuple() requires(std::is_default_constructible_v<Ts>&&...)
      : TupleValues<std::index_sequence_for<Ts...>, Ts...>{} {}
  constexpr Tuple(Ts const&... values) requires(sizeof...(Ts) > 0)
      : TupleValues<std::index_sequence_for<Ts...>, Ts...>{{values}...} {}
};

template <class T>
struct tuple_type;
template <class... Ts>
struct tuple_type<Tuple<Ts...>> {
  using type = Tuple<Ts...>;
};
template <class... Ts>
struct tuple_type<std::tuple<Ts...>> {
  using type = Tuple<Ts...>;
};
/// The Tuple type with the value types of a Tuple or std::tuple.
template <class T>
using tuple_of = typename tuple_type<std::remove_cvref_t<T>>::type;
/// Whether a type is a Tuple or a std::tuple.
template <class T>
concept AnyTuple = requires {
  typename tuple_of<T>;
};

template <AnyTuple T>
inline constexpr std::size_t tuple_size = std::tuple_size_v<std::remove_cvref_t<T>>;
/// The type of the K-th value of a tuple, counted from 0.
template <std::size_t K, AnyTuple T>
using type_at = std::tuple_element_t<K, std::remove_cvref_t<T>>;

/// Returns the K-th value of a tuple, counted from 0.
template <std::size_t K, class T>
constexpr T const& value_at(TupleValue<K, T> const& of) {
  return of.value;
}
template <std::size_t K, class T>
constexpr T& value_at(TupleValue<K, T>& of) {
  return of.value;
}
template <std::size_t K, class... Ts>
constexpr auto const& value_at(std::tuple<Ts...> const& of) {
  return std::get<K>(of);
}

template <class Function, std::size_t... K, class... Ts>
constexpr decltype(auto) with_values_of(Function const& function,
                                        TupleValues<std::index_sequence<K...>, Ts...> const& of) {
  return function(static_cast<TupleValue<K, Ts> const&>(of).value...);
}
/// Calls a function with all values of a tuple as arguments, and returns its result.
template <class Function, class... Ts>
constexpr decltype(auto) with_values(Function const& function, Tuple<Ts...> const& of) {
  return with_values_of(function, of);
}
template <class Function, class... Ts>
constexpr decltype(auto) with_values(Function const& function, std::tuple<Ts...> const& of) {
  return [&]<std::size_t... K>(std::index_sequence<K...>)->decltype(auto) { return function(std::get<K>(of)...); }
  (std::index_sequence_for<Ts...>());
}

/// Returns the values of a Tuple or std::tuple as a Tuple.
template <class... Ts>
constexpr Tuple<Ts...> const& as_tuple(Tuple<Ts...> const& of) {
  return of;
}
template <class... Ts>
constexpr Tuple<Ts...> as_tuple(std::tuple<Ts...> const& of) {
  return with_values([](Ts const&... values) { return Tuple<Ts...>(values...); }, of);
}
/// Returns the values of a Tuple as a std::tuple.
template <class... Ts>
constexpr std::tuple<Ts...> as_std_tuple(Tuple<Ts...> const& of) {
  return with_values([](Ts const&... values) { return std::tuple<Ts...>(values...); }, of);
}

template <class... Tuples>
struct row_of_types {
  using type = Tuple<>;
};
template <class... As>
struct row_of_types<Tuple<As...>> {
  using type = Tuple<As...>;
};
template <class... As, class... Bs, class... Others>
struct row_of_types<Tuple<As...>, Tuple<Bs...>, Others...> : row_of_types<Tuple<As..., Bs...>, Others...> {};
/// The type of a Tuple with the values of several tuples, in order.
template <AnyTuple... Tuples>
using row_type = typename row_of_types<tuple_of<Tuples>...>::type;

template <class... As, class... Bs>
constexpr Tuple<As..., Bs...> two_in_a_row(Tuple<As...> const& a, Tuple<Bs...> const& b) {
  if constexpr (sizeof...(As) == 0)
    return b;
  else if constexpr (sizeof...(Bs) == 0)
    return a;
  else
    return with_values(
        [&](As const&... of_a) {
          return with_values([&](Bs const&... of_b) { return Tuple<As..., Bs...>(of_a..., of_b...); }, b);
        },
        a);
}
constexpr Tuple<> in_a_row() { return {}; }
template <AnyTuple A>
constexpr tuple_of<A> in_a_row(A const& a) {
  return as_tuple(a);
}
/// Returns a Tuple with the values of several tuples, in order.
template <AnyTuple A, AnyTuple B, AnyTuple... Others>
constexpr row_type<A, B, Others...> in_a_row(A const& a, B const& b, Others const&... others) {
  return in_a_row(two_in_a_row(as_tuple(a), as_tuple(b)), others...);
}

}  // namespace scree::detail

namespace std {
template <class... Ts>
struct tuple_size<scree::detail::Tuple<Ts...>> : integral_constant<size_t, sizeof...(Ts)> {};
template <size_t K, class... Ts>
struct tuple_element<K, scree::detail::Tuple<Ts...>> {
  using type = tuple_element_t<K, tuple<Ts...>>;
};
}  // namespace std
