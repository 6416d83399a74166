// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/tuple.hpp"
#include "../fields/standard.hpp"
#include "../formulation/formulation.hpp"
#include "../motion/prescribe.hpp"

#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

// Initial fields that were never set. Storage starts with zeros, which are valid values of most fields.
namespace scree {
namespace detail {

/// Whether a field that was not set may begin with zeros: true if its declaration has a member `may_stay_zero`, or if
/// the field evolves and its declaration has no member `above_zero`.
template <class F, class Evolved>
inline constexpr bool may_begin_at_zero = requires {
  F::may_stay_zero;
}
|| (OneOf<F, Evolved> && !requires { F::above_zero; });

[[noreturn]] void refuse_unset(std::string_view name, std::string_view unit, std::string_view name_of_body);
template <class Evolved, class Body, class F>
void require_set(Body const& body, F field, std::string_view name_of_body) {
  if constexpr (!may_begin_at_zero<F, Evolved>)
    if (body.size() > 0 && body.is_unset(field)) refuse_unset(F::name, F::unit, name_of_body);
}

}  // namespace detail

/// Throws std::invalid_argument if passes or the integrator read a field of a body that no pass writes, no motion gives
/// and the user has not set.
template <class P, class Tag, class Body>
[[gnu::cold]] void require_all_set(Body const& body) {
  constexpr bool evolves = EvolvingBody<Tag>;
  using Evolves = evolves_of<P, Tag>;
  using Evolved = std::conditional_t<evolves, evolved_fields<Evolves>, Fields<>>;
  using Given = std::conditional_t<FollowingBody<Tag>, detail::GivenByMotion, Fields<>>;
  // A pass may write an evolving field itself instead of its rate. Without passes, nothing is meant to change.
  using ByRate = Without<Evolves, written_fields<P, Tag>>;
  constexpr bool has_passes = !std::is_same_v<detail::all_passes_of<typename P::physics>, detail::Tuple<>>;
  using Rates = std::conditional_t<evolves && has_passes, rates_of_evolved<ByRate>, Fields<>>;
  // An evolving field begins with its initial value, even if a projection writes it.
  using Needed = Merge<body_fields<P, Tag>, Without<Common<Rates, typename Body::fields>, Evolved>>;
  using Open = Merge<Without<Needed, Merge<written_fields<P, Tag>, Given>>, Evolved>;
  [&]<class... Fs>(Fields<Fs...>) { (detail::require_set<Evolved>(body, Fs{}, Tag::name), ...); }(Open{});
}

}  // namespace scree

#ifndef SCREE_COMPILED
#include "unset_fields.ipp"
#endif
