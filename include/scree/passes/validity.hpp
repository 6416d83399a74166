// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../core/tuple.hpp"
#include "finite.hpp"
#include "outside_validity.hpp"
#include "resolution.hpp"

#include <string>
#include <string_view>
#include <tuple>
#include <vector>

// The range in which a model is valid, as data. The physics model may define it: `validity(resolution)`, a tuple of
// bounds.
namespace scree {

/// A bound on a function of one particle, for survey(). A run stops if more than a fraction of the particles is beyond
/// it.
template <class Measure>
struct Bound : Measure {
  double most;         ///< largest valid value
  char const* name;    ///< of the function, with its unit: "distance (m)"
  char const* advice;  ///< possible causes, and how to allow more
  double share;        ///< fraction of the particles that may be beyond it, -
};
/// A bound on a measure of one particle: its name, the measure, the largest valid value, advice, and the share of the
/// particles that may be beyond it.
template <class Measure>
Bound<Measure> bound(char const* name, Measure const& measure, double most, char const* advice, double share = 0) {
  return {measure, most, name, advice, share};
}

namespace detail {
template <class Physics>
concept GivesValidity = requires(Physics const& physics) {
  std::tuple_size<decltype(physics.validity(Resolution{}))>::value;
};
}  // namespace detail

/// The bounds of the physics model, or none.
template <class Physics>
auto validity_of([[maybe_unused]] Physics const& physics, [[maybe_unused]] Resolution const& resolution) {
  if constexpr (detail::GivesValidity<Physics>)
    return detail::as_tuple(physics.validity(resolution));
  else
    return detail::Tuple<>();
}

/// Returns the warnings of a model about the present state of a body (WholeBody), one for each of its models.
/// An empty string means that there is no warning. A model has a function warnings_of_state(body), which returns
/// several of them, or warning_of_state(body), which returns one, or both.
template <class Physics, class Whole>
std::vector<std::string> warnings_of_state(Physics const& physics, Whole const& body) {
  std::vector<std::string> all;
  if constexpr (requires { physics.warnings_of_state(body); }) all = physics.warnings_of_state(body);
  if constexpr (requires { physics.warning_of_state(body); }) all.push_back(physics.warning_of_state(body));
  return all;
}

namespace detail {

[[noreturn]] inline void stop_beyond(char const* name, double most, char const* advice, Largest const& found,
                                     std::string const& particle, long particles, long step) {
  throw OutsideValidity(
      formatted("scree: outside the validity of the model: the %s must be at most %.6g, and is %.6g for %s "
                "after step %ld; it is beyond for %.0f of %ld particles; %s",
                name, most, found.value, particle.c_str(), step, found.beyond, particles, advice));
}

}  // namespace detail

/// Throws OutsideValidity if more of all particles than allowed are beyond a bound. If there are several ranks, the one
/// that has the worst particle throws. The message names the body unless `of_body` is empty.
template <class Body, class Measure>
[[gnu::cold]] void stop_beyond(Body const& body, Bound<Measure> const& bound, Largest const& found, long step,
                               long particles, std::string_view of_body = {}) {
  if (found.beyond > bound.share * double(particles) && found.particle != detail::no_particle)
    detail::stop_beyond(
        bound.name, bound.most, bound.advice, found,
        detail::name_of_particle(body, found.particle, of_body) + detail::place_of_particle(body, found.particle),
        particles, step);
}

}  // namespace scree
