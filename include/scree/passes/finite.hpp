// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../fields/standard.hpp"
#include "survey.hpp"

#include <stdexcept>
#include <string>
#include <string_view>

// NaN and infinity spread over all particles within a few steps; an early report names their origin.
namespace scree {
namespace detail {

/// "1" or "(1, 2)".
[[gnu::cold]] std::string text_of_numbers(double const* numbers, int count);
template <class T>
[[gnu::cold]] std::string text_of(T const& value) {
  if constexpr (std::is_arithmetic_v<T>) {
    double const number = double(value);
    return text_of_numbers(&number, 1);
  } else {
    auto const numbers = value.template cast<double>().eval();
    return text_of_numbers(numbers.data(), int(numbers.size()));
  }
}
template <Field F, class Body>
[[gnu::cold]] auto value_at(Body const& body, F field, int i) {
  return body.to_host(field)[static_cast<std::size_t>(i)];
}
template <Field F, class Body>
[[gnu::cold]] void describe_if_not_finite(Body const& body, F field, int i, std::string& text) {
  auto const value = value_at(body, field, i);
  if (is_finite(value)) return;
  text += formatted("%s%s = %s %s", text.empty() ? "" : ", ", std::string(F::name).c_str(), text_of(value).c_str(),
                    std::string(F::unit).c_str());
}
/// The name of a particle in messages, "particle 7" or "particle 7 of the clay": its identity, or its index if the body
/// has none. `of_body` is the name of the body, empty where it is clear.
template <class Body>
[[gnu::cold]] std::string name_of_particle(Body const& body, int i, std::string_view of_body = {}) {
  if constexpr (OneOf<Identity, typename Body::fields>) i = value_at(body, fields::identity, i);
  return formatted("particle %d", i) + (of_body.empty() ? "" : " of the ") + std::string(of_body);
}
/// " at (1, 2) m", or nothing.
template <class Body>
[[gnu::cold]] std::string place_of_particle([[maybe_unused]] Body const& body, [[maybe_unused]] int i) {
  if constexpr (OneOf<Position, typename Body::fields>)
    return formatted(" at %s m", text_of(value_at(body, fields::position, i)).c_str());
  return "";
}

}  // namespace detail

/// Throws std::runtime_error if survey() found a particle with a value of one of the fields that is not finite. The
/// message gives its identity (its index if the body has none), the name of the body unless it is empty, the field, the
/// step and the position (m).
template <class Body, class... Fs>
void stop_at(int first_not_finite, Body const& body, Fields<Fs...>, long step, std::string_view of_body = {}) {
  if (first_not_finite == detail::no_particle) return;
  std::string found;
  (detail::describe_if_not_finite(body, Fs{}, first_not_finite, found), ...);
  throw std::runtime_error(detail::formatted("scree: %s is not finite after step %ld%s: %s",
                                             detail::name_of_particle(body, first_not_finite, of_body).c_str(), step,
                                             detail::place_of_particle(body, first_not_finite).c_str(), found.c_str()));
}

/// Throws std::runtime_error, as stop_at() does, if a value of one of the fields is not finite; the message names
/// the owned particle with the lowest index that has such a value. It takes one sweep over the particles; values are
/// copied to the host only for the message.
template <class Body, class List>
void check_finite(Body const& body, List list, long step, std::string_view of_body = {}) {
  stop_at(survey(body, list).first_not_finite, body, list, step, of_body);
}

}  // namespace scree

#ifndef SCREE_COMPILED
#include "finite.ipp"
#endif
