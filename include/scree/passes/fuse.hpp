// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/tuple.hpp"
#include "run_passes.hpp"
#include "together.hpp"

#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

// Fusion of passes into fewer sweeps with the same results. The fields that the passes read and write determine at
// compile time which passes can be fused.
namespace scree {
namespace detail {

template <class Body, class A, class B>
inline constexpr bool commute_on = !intersects<writes_of_pass<Body, A>, reads_of_pass<Body, B>> &&
                                   !intersects<reads_of_pass<Body, A>, writes_of_pass<Body, B>> &&
                                   !intersects<writes_of_pass<Body, A>, writes_of_pass<Body, B>>;
template <class A, class B, class... Bs>
constexpr bool commute_on_all(Bodies<Bs...>) {
  return (commute_on<Bs, A, B> && ...);
}
/// Whether two passes give the same results in either order.
template <class A, class B>
inline constexpr bool commute = commute_on_all<A, B>(typename bodies_of_pass<A>::type{}) &&
                                commute_on_all<A, B>(typename bodies_of_pass<B>::type{});

template <class T, class... Ts>
inline constexpr bool is_one_of = (std::is_same_v<T, Ts> || ...);
/// One contribution to a field: a term that is summed over a body through a lens.
template <class Body, class Lens, class Term>
struct Summand {
  static constexpr bool is_known = std::is_empty_v<Term>;  // any two values of the type are equal
};

template <class F, class Over>
struct summands_of;
template <class F, class Body, class Lens, class... Terms>
struct summands_of<F, Over<Body, Lens, Terms...>> {
  using type = row_type<std::conditional_t<OneOf<F, adds_of<Terms>>, Tuple<Summand<Body, Lens, Terms>>, Tuple<>>...>;
};
template <class F, class Pass>
struct summands_of_pass;
template <class F, class T, class W, class Then, class... Overs>
struct summands_of_pass<F, PairPass<T, W, Then, Overs...>> {
  using type = row_type<typename summands_of<F, Overs>::type...>;
};
template <class A, class B>
inline constexpr bool are_equal_sets = false;
template <class... As, class... Bs>
inline constexpr bool are_equal_sets<Tuple<As...>, Tuple<Bs...>> = (As::is_known && ...) &&
                                                                   (is_one_of<As, Bs...> && ...) &&
                                                                   (is_one_of<Bs, As...> && ...);

/// Whether two passes compute the same sums for the fields to which both add.
template <class A, class B, class List>
inline constexpr bool have_equal_sums = false;
template <class A, class B, class... Fs>
inline constexpr bool have_equal_sums<A, B, Fields<Fs...>> =
    (are_equal_sets<typename summands_of_pass<Fs, A>::type, typename summands_of_pass<Fs, B>::type> && ...);

/// Whether two lenses of this type can be compared.
template <class Lens>
inline constexpr bool is_comparable_lens = std::is_empty_v<Lens> || requires(Lens const& a, Lens const& b) {
  { a == b } -> std::convertible_to<bool>;
};

/// Whether one sweep over a body gives the same results as two passes one after the other.
template <class A, class B>
inline constexpr bool may_fuse = false;
template <class T, class ThenA, class... As, class ThenB, class... Bs>
inline constexpr bool may_fuse<PairPass<T, Everywhere, ThenA, As...>, PairPass<T, Everywhere, ThenB, Bs...>> = [] {
  using A = PairPass<T, Everywhere, ThenA, As...>;
  using B = PairPass<T, Everywhere, ThenB, Bs...>;
  if constexpr (stores_sums<ThenA> || stores_sums<ThenB>) {
    return false;
  } else {
    return !intersects<typename A::stored, reads_of_pass<T, B>> && A::template may_write<typename B::stored> &&
           have_equal_sums<A, B, Common<typename A::adds, typename B::adds>> &&
           (is_comparable_lens<decltype(As::lens)> && ...);
  }
}();

template <class Over, class Term>
inline constexpr bool has_term = false;
template <class Body, class Lens, class... Terms, class Term>
inline constexpr bool has_term<Over<Body, Lens, Terms...>, Term> = is_one_of<Term, Terms...>;
template <class A, class B>
inline constexpr bool same_source = false;
template <class Body, class Lens, class... As, class... Bs>
inline constexpr bool same_source<Over<Body, Lens, As...>, Over<Body, Lens, Bs...>> = true;

template <class Body, class Lens, class... Terms>
Over<Body, Lens, Terms...> over_tuple(Lens const& lens, Tuple<Terms...> const& terms) {
  return {lens, terms};
}
/// Returns the terms of two passes over the same source, without duplicates.
template <class Body, class Lens, class... As, class... Bs>
auto joined(Over<Body, Lens, As...> const& a, Over<Body, Lens, Bs...> const& b) {
  if constexpr (!std::is_empty_v<Lens>)
    if (!(a.lens == b.lens))
      throw std::logic_error(
          "scree: passes that are computed in one sweep see a body through two lenses of one type with different "
          "values: give the lenses different types");
  auto const unless_in_a = [](auto const& term) {
    using Term = std::remove_cvref_t<decltype(term)>;
    if constexpr (has_term<Over<Body, Lens, As...>, Term>)
      return Tuple<>();
    else
      return Tuple<Term>(term);
  };
  return with_values(
      [&](Bs const&... terms) { return over_tuple<Body>(a.lens, in_a_row(a.terms, unless_in_a(terms)...)); }, b.terms);
}

/// Returns a source of one pass, extended by the terms that another pass sums over the same body through the same lens.
template <class A, class... Bs>
auto joined_with_same(A const& a, Tuple<Bs...> const& others) {
  auto const add = [&](auto const& sum, auto const& b) {
    if constexpr (same_source<A, std::remove_cvref_t<decltype(b)>>)
      return joined(sum, b);
    else
      return sum;
  };
  if constexpr (sizeof...(Bs) == 0) {
    return a;
  } else {
    auto const first = add(a, value_at<0>(others));
    return with_values([&](auto const&, auto const&... rest) { return joined_with_same(first, Tuple(rest...)); },
                       others);
  }
}
/// Returns a source of one pass, or nothing if the other pass has the same source.
template <class B, class... As>
auto unless_same(B const& b, Tuple<As...> const&) {
  if constexpr ((same_source<As, B> || ...))
    return Tuple<>();
  else
    return Tuple<B>(b);
}

template <class T, class Then, class... Overs>
PairPass<T, Everywhere, Then, Overs...> pass_of(PassLabel const& label, Then const& then,
                                                Tuple<Overs...> const& overs) {
  return {label, {}, then, overs};
}
/// Returns the label of two fused passes: "scree::a" and "scree::b" give "scree::a+b".
inline PassLabel joined_labels(PassLabel const& a, PassLabel const& b) {
  auto const end = b.text().rfind("::");
  bool const same = end != std::string_view::npos && a.text().starts_with(b.text().substr(0, end + 2));
  return a + "+" + (same ? b.text().substr(end + 2) : b.text());
}

template <class T, class ThenA, class... As, class ThenB, class... Bs>
auto fuse_two(PairPass<T, Everywhere, ThenA, As...> const& a, PairPass<T, Everywhere, ThenB, Bs...> const& b) {
  auto const overs = with_values(
      [&](As const&... each) {
        return with_values(
            [&](Bs const&... other) {
              return in_a_row(Tuple(joined_with_same(each, b.overs)...), unless_same(other, a.overs)...);
            },
            b.overs);
      },
      a.overs);
  return pass_of<T>(joined_labels(a.label, b.label), together(a.then, b.then), overs);
}

/// Whether pass K of a list may run last without a change of the results.
template <class Passes, std::size_t K, std::size_t... M>
constexpr bool can_be_last(std::index_sequence<M...>) {
  return (commute<type_at<K, Passes>, type_at<K + 1 + M, Passes>> && ...);
}
/// The pass of a list with which the next pass can be fused without a change of the results, and the position in the
/// list at which the fused pass runs.
struct FusionPlace {
  int number = -1;  ///< -1 if there is no such pass
  bool last = false;
};
template <class Next, class Passes, std::size_t N = tuple_size<Passes>, bool MovesUp = true>
constexpr FusionPlace place_for() {
  if constexpr (N == 0) {
    return {};
  } else {
    using Pass = type_at<N - 1, Passes>;
    if constexpr (may_fuse<Pass, Next>) {
      if (MovesUp) return {int(N) - 1, false};
      if (can_be_last<Passes, N - 1>(std::make_index_sequence<tuple_size<Passes> - N>())) return {int(N) - 1, true};
    }
    constexpr bool moves_farther = MovesUp && commute<Pass, Next>;
    return place_for<Next, Passes, N - 1, moves_farther>();
  }
}
/// Returns a list in which pass number `Place` is replaced by the pass `both`.
template <std::size_t Place, class... Passes, class Both, std::size_t... K>
auto with_fused(Tuple<Passes...> const& passes, Both const& both, std::index_sequence<K...>) {
  auto const pick = [&](auto const& pass, auto k) -> auto const& {
    if constexpr (k == Place)
      return both;
    else
      return pass;
  };
  return Tuple<std::conditional_t<K == Place, Both, Passes>...>(
      pick(value_at<K>(passes), std::integral_constant<std::size_t, K>())...);
}
template <std::size_t Place, class... Passes, class Both, std::size_t... K>
auto with_fused_last(Tuple<Passes...> const& passes, Both const& both, std::index_sequence<K...>) {
  auto const unless_there = [](auto k, auto const& pass) {
    if constexpr (k == Place)
      return Tuple<>();
    else
      return Tuple(pass);
  };
  return in_a_row(unless_there(std::integral_constant<std::size_t, K>(), value_at<K>(passes))..., Tuple(both));
}
template <class Next, class... Passes>
auto with_next(Tuple<Passes...> const& passes, Next const& next) {
  static constexpr FusionPlace place = place_for<Next, Tuple<Passes...>>();
  constexpr auto all = std::index_sequence_for<Passes...>();
  if constexpr (place.number < 0) {
    return in_a_row(passes, Tuple(next));
  } else {
    constexpr auto number = static_cast<std::size_t>(place.number);
    auto const both = fuse_two(value_at<number>(passes), next);
    if constexpr (place.last)
      return with_fused_last<number>(passes, both, all);
    else
      return with_fused<number>(passes, both, all);
  }
}
template <class... Done>
auto fused_onto(Tuple<Done...> const& done) {
  return done;
}
template <class... Done, class Next, class... Others>
auto fused_onto(Tuple<Done...> const& done, Next const& next, Others const&... others) {
  return fused_onto(with_next(done, next), others...);
}

/// Returns the passes of fused() as a Tuple.
template <AnyTuple Passes>
auto in_fewer_sweeps(Passes const& passes) {
  return with_values([](auto const&... each) { return fused_onto(Tuple<>(), each...); }, passes);
}

}  // namespace detail

/// Returns the passes of a list fused into fewer sweeps with the same results. A pair pass is fused with an earlier
/// pair pass over the same body if it does not depend on the earlier pass and if either of the two can be moved past
/// the passes between them. Sums that both need are computed once.
template <detail::AnyTuple Passes>
auto fused(Passes const& passes) {
  return detail::as_std_tuple(detail::in_fewer_sweeps(passes));
}

namespace detail {
template <class Target, class Passes>
inline constexpr bool are_point_passes = are_point_passes<Target, tuple_of<Passes>>;
template <class Target, class... Passes>
inline constexpr bool are_point_passes<Target, Tuple<Passes...>> = false;
template <class Target, class... Functions>
inline constexpr bool are_point_passes<Target, Tuple<PointPass<Target, Functions>...>> = true;
}  // namespace detail

/// Returns a function of a particle that calls the given function and then the functions of the point passes.
template <class P, class Function, detail::AnyTuple PointPasses>
auto with_point_passes(Function const& function, PointPasses const& passes) {
  return detail::with_values([&](auto const&... each) { return in_turn<P>(function, each.function...); }, passes);
}

namespace detail {
template <class Target, class Pass, class Written>
inline constexpr bool may_be_followed = false;
template <class Target, class Where, class Then, class... Overs, class Written>
inline constexpr bool may_be_followed<Target, PairPass<Target, Where, Then, Overs...>, Written> =
    PairPass<Target, Where, Then, Overs...>::template may_write<Written>;

/// The last pass of a list, or `IfNone` if the list is empty.
template <class IfNone, class Passes, std::size_t N = tuple_size<Passes>>
struct last_of {
  using type = type_at<N - 1, Passes>;
};
template <class IfNone, class Passes>
struct last_of<IfNone, Passes, 0> {
  using type = IfNone;
};
}  // namespace detail

/// Runs a list of passes in order and then applies a function to each particle of the target body. The function is
/// fused with the last pass if that is a pair pass over the target body with a function of its sums, and reads from
/// neighbours none of the fields that the function writes.
template <class Target, class Sys, class Function, detail::AnyTuple Passes>
void run_passes_and(Sys& system, Passes const& passes, Function const& function) {
  constexpr std::size_t count = detail::tuple_size<Passes>;
  using Last = typename detail::last_of<PointPass<Target, Function>, Passes>::type;
  if constexpr (detail::may_be_followed<Target, Last, writes_of<Function>>) {
    auto const last = detail::value_at<count - 1>(passes).template followed_by<typename Sys::policy>(function);
    [&]<std::size_t... K>(std::index_sequence<K...>) {
      detail::AnyPass const values[] = {detail::any_pass<Sys>(detail::value_at<K>(passes))...,
                                        detail::any_pass<Sys>(last)};
      system.run(values);
    }
    (std::make_index_sequence<count - 1>());
  } else {
    run_passes(system, passes);
    point_pass<Target>("scree::update", function).run(system);
  }
}

}  // namespace scree
