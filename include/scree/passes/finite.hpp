// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../fields/standard.hpp"
#include "../kernels/default_bases.hpp"
#include "survey.hpp"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

// Checks for non-finite values. NaN and infinity spread over all particles within a few steps; an early report names
// the particle at which they started.
namespace scree {
namespace detail {

/// A field for messages about the values of a particle.
struct FieldInWords {
  std::string_view name, unit;
  void const* key;      // &field_key of the field
  std::size_t numbers;  // numbers in a value; 0 for integers, which are always finite
  bool in_float;        // whether the numbers are in single precision
};
template <class P, class F>
constexpr FieldInWords in_words() {
  using Value = value_t<P, F>;
  if constexpr (std::is_arithmetic_v<Value>)
    return {F::name, F::unit, &field_key<F>, std::is_integral_v<Value> ? 0 : 1, std::is_same_v<Value, float>};
  else {
    static_assert(sizeof(Value) == Value::SizeAtCompileTime * sizeof(typename Value::Scalar));
    return {F::name, F::unit, &field_key<F>,
            std::is_integral_v<typename Value::Scalar> ? 0 : std::size_t(Value::SizeAtCompileTime),
            std::is_same_v<typename Value::Scalar, float>};
  }
}

/// Returns numbers as text, for instance "1" or "(1, 2)".
[[gnu::cold]] std::string text_of_numbers(std::vector<double> const& numbers);

/// Returns an array of one index, for UntypedParticles::to_host().
template <class P>
[[gnu::cold]] Array<P, int const> alone(AnyParticles<P> const& body, int i) {
  return array_of<P>(body.space(), std::vector<int>{i});
}
/// Returns the name of a particle for messages, for instance "particle 7" or "particle 7 of the clay". The number is
/// the identity of the particle, or its index if the body has no identities. `of_body` is the name of the body; leave
/// it empty if there is only one.
template <class P>
[[gnu::cold]] std::string name_of_particle(AnyParticles<P> const& body, int i, std::string_view of_body = {}) {
  if (body.has(fields::identity)) i = body.to_host(fields::identity, alone(body, i)).front();
  return formatted("particle %d", i) + (of_body.empty() ? "" : " of the ") + std::string(of_body);
}
/// Returns the position of a particle as text, for instance " at (1, 2) m", or "" if the body has no positions.
template <class P>
[[gnu::cold]] std::string place_of_particle(AnyParticles<P> const& body, int i) {
  if (!body.has(fields::position)) return "";
  auto const x = body.to_host(fields::position, alone(body, i)).front().template cast<double>().eval();
  return formatted(" at %s m", text_of_numbers({x.data(), x.data() + x.size()}).c_str());
}
/// Throws std::runtime_error with the message that stop_at() describes.
template <class P>
[[gnu::cold]] void stop_at_particle(int i, AnyParticles<P> const& body, std::initializer_list<FieldInWords> fields,
                                    long step, std::string_view of_body) {
  auto const which = alone(body, i);
  std::string found;
  for (auto const& field : fields) {
    std::vector<double> value;
    auto const read = [&](auto numbers) {
      body.columns().to_host(body.columns().find(field.key), which, numbers.data());
      value.assign(numbers.begin(), numbers.end());
    };
    if (field.numbers > 0)
      field.in_float ? read(std::vector<float>(field.numbers)) : read(std::vector<double>(field.numbers));
    if (std::all_of(value.begin(), value.end(), [](double number) { return is_finite(number); })) continue;
    found += formatted("%s%s = %s %s", found.empty() ? "" : ", ", std::string(field.name).c_str(),
                       text_of_numbers(value).c_str(), std::string(field.unit).c_str());
  }
  throw std::runtime_error(formatted("scree: %s is not finite after step %ld%s: %s",
                                     name_of_particle(body, i, of_body).c_str(), step,
                                     place_of_particle(body, i).c_str(), found.c_str()));
}

}  // namespace detail

/// Throws std::runtime_error if survey() found a particle with a non-finite value in one of the fields. The message
/// gives the identity of the particle (its index if the body has no identities), the name of the body unless it is
/// empty, the field, the step and the position (m).
template <class P, class... Fs>
void stop_at(int first_not_finite, AnyParticles<P> const& body, Fields<Fs...>, long step,
             std::string_view of_body = {}) {
  if (first_not_finite != detail::no_particle)
    detail::stop_at_particle(first_not_finite, body, {detail::in_words<P, Fs>()...}, step, of_body);
}

/// Throws std::runtime_error with the message of stop_at() if a value of one of the fields is not finite. The message
/// names the owned particle with the lowest index among those with non-finite values. The check takes one sweep over
/// the particles; values are copied to the host only for the message.
template <class Body, class List>
void check_finite(Body const& body, List list, long step, std::string_view of_body = {}) {
  stop_at(survey(body, list).first_not_finite, body, list, step, of_body);
}

}  // namespace scree

#ifdef SCREE_COMPILED
#define SCREE_INSTANCES(P)                                                                                          \
  SCREE_INSTANCE std::string scree::detail::name_of_particle(scree::AnyParticles<P> const&, int, std::string_view); \
  SCREE_INSTANCE std::string scree::detail::place_of_particle(scree::AnyParticles<P> const&, int);                  \
  SCREE_INSTANCE void scree::detail::stop_at_particle(                                                              \
      int, scree::AnyParticles<P> const&, std::initializer_list<scree::detail::FieldInWords>, long, std::string_view)
SCREE_FOR_DEFAULT_BASES(SCREE_INSTANCES);
#undef SCREE_INSTANCES
#else
#include "finite.ipp"
#endif
