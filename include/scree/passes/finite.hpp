// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/standard.hpp"
#include "survey.hpp"

#include <cstdio>
#include <stdexcept>
#include <string>

// NaN and infinity spread over all particles within a few steps; an early report names their origin.
namespace scree {
namespace detail {

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
/// "particle 7": its identity, or its index if the body has none;
template <class Body>
std::string name_of_particle(Body const& body, int i) {
  if constexpr (OneOf<Identity, typename Body::fields>) i = value_at(body, fields::identity, i);
  return "particle " + std::to_string(i);
}
/// " at (1, 2) m", or nothing.
template <class Body>
std::string place_of_particle([[maybe_unused]] Body const& body, [[maybe_unused]] int i) {
  if constexpr (OneOf<Position, typename Body::fields>)
    return " at " + text_of(value_at(body, fields::position, i)) + " m";
  return "";
}

}  // namespace detail

/// Stops with std::runtime_error if survey() found a particle with a value of one of the fields that is not finite. The
/// message gives its identity (its index if the body has none), the field, the step and the position (m).
template <class Body, class... Fs>
void stop_at(int first_not_finite, Body const& body, Fields<Fs...>, long step) {
  if (first_not_finite == detail::no_particle) return;
  std::string found;
  (detail::describe_if_not_finite(body, Fs{}, first_not_finite, found), ...);
  throw std::runtime_error("scree: " + detail::name_of_particle(body, first_not_finite) + " is not finite after step " +
                           std::to_string(step) + detail::place_of_particle(body, first_not_finite) + ": " + found);
}

/// The same for the owned particle with the lowest index that has such a value. One sweep over the particles; values
/// are copied to the host only for the message.
template <class Body, class List>
void check_finite(Body const& body, List list, long step) {
  stop_at(survey(body, list).first_not_finite, body, list, step);
}

}  // namespace scree
