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

// The range in which a model is valid. A physics model may define this range by a function `validity(resolution)`,
// which returns a tuple of bounds.
namespace scree {

/// An upper bound on a function of one particle, for survey(). A run stops if more than a given fraction of the
/// particles is beyond the bound.
template <class Measure>
struct Bound : Measure {
  double most;         ///< largest valid value
  char const* name;    ///< name of the function with its unit, for instance "distance (m)"
  char const* advice;  ///< possible causes, and how to relax the bound
  double share;        ///< fraction of the particles that may be beyond the bound, -
};
/// Returns an upper bound on a measure of one particle, from its name, the measure, the largest valid value, advice,
/// and the fraction of the particles that may be beyond the bound.
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

/// Returns the bounds of a physics model, or an empty Tuple if it defines none.
template <class Physics>
auto validity_of([[maybe_unused]] Physics const& physics, [[maybe_unused]] Resolution const& resolution) {
  if constexpr (detail::GivesValidity<Physics>)
    return detail::as_tuple(physics.validity(resolution));
  else
    return detail::Tuple<>();
}

/// Returns the warnings of a physics model about the present state of a body (WholeBody), one for each of its models;
/// an empty string means no warning. A model may have a function warnings_of_state(body), which returns several
/// warnings, a function warning_of_state(body), which returns one, or both.
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

/// Throws OutsideValidity if more than the allowed fraction of all particles is beyond a bound. With several ranks, the
/// rank with the largest value throws. The message names the body unless `of_body` is empty.
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
