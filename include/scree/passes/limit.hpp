// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/tuple.hpp"
#include "../fields/whole_body.hpp"
#include "finite.hpp"
#include "resolution.hpp"
#include "time_step.hpp"
#include "validity.hpp"

#include <concepts>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

// Time step limits, which a physics model defines as data.
namespace scree {

/// Whether a solver can advance a physics model, which requires a function limits(resolution) that returns a tuple of
/// time step limits made by limit().
template <class Physics>
concept HasLimits = requires(Physics const& physics) {
  std::tuple_size<decltype(physics.limits(Resolution{}))>::value;
};

/// Whether L is a limit on the time step, as made by limit().
template <class L>
concept StepLimit = requires(L const& limit, Largest const* largest) {
  { limit.name } -> std::convertible_to<std::string_view>;
  std::tuple_size<decltype(limit.measures())>::value;
  { limit.from(largest) } -> std::same_as<TimeStepLimit>;
  limit.over(2);
};
namespace detail {
template <class Limits>
inline constexpr bool are_limits = false;
template <StepLimit... Limits>
inline constexpr bool are_limits<Tuple<Limits...>> = true;
template <StepLimit... Limits>
inline constexpr bool are_limits<std::tuple<Limits...>> = true;
/// Whether all functions that determine the limits of a tuple return numbers.
template <class P, class Limits>
inline constexpr bool measure_numbers = true;
template <class P, StepLimit... Limits>
inline constexpr bool measure_numbers<P, Tuple<Limits...>> =
    (return_numbers<P, tuple_of<decltype(std::declval<Limits const&>().measures())>> && ...);
template <class P, StepLimit... Limits>
inline constexpr bool measure_numbers<P, std::tuple<Limits...>> = measure_numbers<P, Tuple<Limits...>>;
/// Whether all functions that determine the limits of a physics model return numbers.
template <class P, class Physics>
inline constexpr bool limits_measure_numbers = true;
template <class P, HasLimits Physics>
inline constexpr bool limits_measure_numbers<P, Physics> =
    measure_numbers<P, decltype(std::declval<Physics const&>().limits(Resolution{}))>;
}  // namespace detail

/// A limit on the time step from constants of the material and the spacing.
struct ConstantLimit {
  std::string_view name;
  double step = 0;  ///< s

  /// Returns no functions of a particle, because the limit does not depend on the state.
  static detail::Tuple<> measures() { return {}; }
  /// Returns the limit in the form in which the solver compares limits.
  TimeStepLimit from(Largest const*) const { return {name, step, TimeStepLimit::never}; }
  /// Returns the limit on each of `steps` time steps that use the same rate.
  ConstantLimit over(int steps) const { return {name, step / steps}; }
};
/// Returns a constant limit on the time step, s.
inline ConstantLimit limit(std::string_view name, double step) { return {name, step}; }

/// A limit on the time step that depends on the state through the largest value of a function of one particle over the
/// material.
template <class Measure, class Step>
struct StateLimit {
  std::string_view name;
  Measure measure;  ///< non-negative function of one particle: `reads`, operator()(i)
  Step step;        ///< longest time step for the largest value of the measure, s
  int steps = 1;    ///< number of time steps that the limit covers

  /// Returns the function of one particle whose largest value determines the limit.
  detail::Tuple<Measure> measures() const { return {measure}; }
  /// Returns the limit for the largest value of the measure.
  TimeStepLimit from(Largest const* largest) const {
    double const longest = step(largest->value);
    // The time in which the state changes does not depend on the number of steps that the limit covers.
    return {name, longest / steps, longest};
  }
  /// Returns the limit on each of `more` time steps that use the same rate.
  StateLimit over(int more) const { return {name, measure, step, steps * more}; }
};
/// Returns a limit on the time step that depends on the state. `step` is a function that returns the longest time step
/// (s) for the largest value of `measure`, a function of one particle with `reads`.
template <class Measure, class Step>
StateLimit<Measure, Step> limit(std::string_view name, Measure const& measure, Step const& step) {
  static_assert(
      requires {
        { step(1.0) } -> std::convertible_to<double>;
      },
      "the last argument of limit() is a function of the largest value, which returns a step in s");
  return {name, measure, step};
}

/// Returns the limits for the present state, from one sweep over the particles. Throws the exceptions of check_finite()
/// and stop_beyond(). `of_body` is the name of the body for messages, or empty.
template <class... Of, class Evolved, detail::AnyTuple Limits, detail::AnyTuple Bounds = detail::Tuple<>>
std::vector<TimeStepLimit> limits_of(WholeBody<Of...> const& whole, Evolved evolved, Limits const& limits, long step,
                                     Bounds const& bounds = {}, std::string_view of_body = {}) {
  auto const& body = whole.here();
  using detail::with_values;
  auto const all =
      with_values([&](auto const&... each) { return detail::in_a_row(each.measures()..., bounds); }, limits);
  auto const found = with_values([&](auto const&... each) { return survey(body, evolved, each...); }, all);
  stop_at(found.first_not_finite, body, evolved, step, of_body);
  auto const [largest, particles] = whole.joined(found.largest);
  Largest const* of_bound = largest.data() + (largest.size() - detail::tuple_size<Bounds>);
  [[maybe_unused]] long const among = particles;
  with_values([&](auto const&... each) { (stop_beyond(body, each, *of_bound++, step, among, of_body), ...); }, bounds);
  Largest const* next = largest.data();
  auto const from = [&](auto const& each) {
    Largest const* const of_limit = next;
    next += detail::tuple_size<decltype(each.measures())>;
    return each.from(of_limit);
  };
  return with_values([&](auto const&... each) { return std::vector<TimeStepLimit>{from(each)...}; }, limits);
}

}  // namespace scree
