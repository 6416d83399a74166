// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/standard.hpp"
#include "formulation.hpp"

#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

// Initial fields that were never set. Storage starts with zeros, which are valid values of most fields.
namespace scree {
namespace detail {

/// Whether zeros are intended in a field that nobody set: true if its declaration has a member `may_stay_zero`, and for
/// fields that evolve unless their declaration has a member `above_zero`.
template <class F, class Evolved>
inline constexpr bool may_begin_at_zero = requires {
  F::may_stay_zero;
}
|| (OneOf<F, Evolved> && !requires { F::above_zero; });

[[noreturn]] inline void refuse_unset(std::string_view name, std::string_view unit, std::string_view name_of_body) {
  throw std::invalid_argument(formatted(
      "scree: %s (%s) of the %s is read by passes, and nothing gives or computes it: give it before the first step, "
      "with set(); zeros too, if they are meant",
      std::string(name).c_str(), std::string(unit).c_str(), std::string(name_of_body).c_str()));
}
template <class Evolved, class Body, class F>
void require_set(Body const& body, F field, std::string_view name_of_body) {
  if constexpr (!may_begin_at_zero<F, Evolved>)
    if (body.size() > 0 && body.is_unset(field)) refuse_unset(F::name, F::unit, name_of_body);
}

}  // namespace detail

/// Throws std::invalid_argument if passes read a field of a body that no pass writes, no motion gives and nobody has
/// set.
template <class P, class Tag, class Body>
[[gnu::cold]] void require_all_set(Body const& body) {
  using Evolved = std::conditional_t<EvolvingBody<Tag>, evolved_fields<typename P::physics::evolves>, Fields<>>;
  using Given =
      std::conditional_t<FollowingBody<Tag>, Fields<Velocity, Acceleration, VelocityGradient>, Fields<>>;  // by motion
  // A field that evolves begins with its initial value, also where a projection writes it.
  using Open = Merge<Without<body_fields<P, Tag>, Merge<written_fields<P, Tag>, Given>>, Evolved>;
  [&]<class... Fs>(Fields<Fs...>) { (detail::require_set<Evolved>(body, Fs{}, Tag::name), ...); }(Open{});
}

}  // namespace scree
