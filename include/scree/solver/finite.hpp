// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/particles.hpp"
#include "../fields/standard.hpp"

#include <cstdio>
#include <limits>
#include <stdexcept>

// A value that is not a number spreads over all particles within a few steps; said early, it names its origin.
namespace scree {
namespace detail {

template <class T>
SCREE_FN bool is_finite(T const& value) {
  if constexpr (std::is_integral_v<T>) {
    return true;
  } else if constexpr (std::is_floating_point_v<T>) {
    return Kokkos::isfinite(value);
  } else {
    for (int k = 0; k < value.size(); ++k)
      if (!Kokkos::isfinite(value.data()[k])) return false;
    return true;
  }
}

/// The lowest index of a particle with a value that is not finite.
template <class P, class List>
struct FirstNotFinite;
template <class P, class... Fs>
struct FirstNotFinite<P, Fields<Fs...>> {
  Columns<P, Fields<Fs...>> columns;
  SCREE_FN void operator()(int i, int& first) const {
    bool const finite = (is_finite(columns.load(Fs{}, i)) && ...);
    if (!finite && i < first) first = i;
  }
};

template <class T>
std::string text_of(T const& value) {
  if constexpr (std::is_arithmetic_v<T>) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", double(value));
    return text;
  } else {
    std::string text = "(";
    for (int k = 0; k < value.size(); ++k) text += (k == 0 ? "" : ", ") + text_of(value.data()[k]);
    return text + ")";
  }
}
template <Field F, class Body>
auto value_at(Body const& body, F field, int i) {
  return body.to_host(field)[static_cast<std::size_t>(i)];
}
template <Field F, class Body>
void describe_if_not_finite(Body const& body, F field, int i, std::string& text) {
  auto const value = value_at(body, field, i);
  if (is_finite(value)) return;
  text += (text.empty() ? "" : ", ") + std::string(F::name) + " = " + text_of(value) + " " + std::string(F::unit);
}

}  // namespace detail

/// Stops with std::runtime_error if a value of one of the fields of an owned particle is not finite. The message names
/// the particle with the lowest index by its identity (by its index if the body has none), the field, the step and the
/// position (m). One sweep over the particles; values come to the host only for the message.
template <class Body, class... Fs>
void check_finite(Body const& body, Fields<Fs...> list, long step) {
  using P = typename Body::policy;
  constexpr int none = std::numeric_limits<int>::max();
  int first = none;
  if constexpr (sizeof...(Fs) > 0)
    Kokkos::parallel_reduce("scree::check_finite", Kokkos::RangePolicy<typename P::space>(0, body.size()),
                            detail::FirstNotFinite<P, Fields<Fs...>>{body.select(list)}, Kokkos::Min<int>(first));
  if (first == none) return;

  std::string found, who = std::to_string(first), where;
  (detail::describe_if_not_finite(body, Fs{}, first, found), ...);
  if constexpr (OneOf<Identity, typename Body::fields>) who = std::to_string(detail::value_at(body, identity, first));
  if constexpr (OneOf<Position, typename Body::fields>)
    where = " at " + detail::text_of(detail::value_at(body, position, first)) + " m";
  throw std::runtime_error("scree: particle " + who + " is not finite after step " + std::to_string(step) + where +
                           ": " + found);
}

}  // namespace scree
