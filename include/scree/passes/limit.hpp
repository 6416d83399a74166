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

// Time step limits as data. The physics model names them.
namespace scree {

/// A physics model that a solver can advance: limits(resolution) gives a tuple of time step limits, made by limit().
template <class Physics>
concept HasLimits = requires(Physics const& physics) {
  std::tuple_size<decltype(physics.limits(Resolution{}))>::value;
};

/// A limit of the step, made by limit().
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
/// Whether all limits of a tuple are found from functions that return numbers.
template <class P, class Limits>
inline constexpr bool measure_numbers = true;
template <class P, StepLimit... Limits>
inline constexpr bool measure_numbers<P, Tuple<Limits...>> =
    (return_numbers<P, tuple_of<decltype(std::declval<Limits const&>().measures())>> && ...);
template <class P, StepLimit... Limits>
inline constexpr bool measure_numbers<P, std::tuple<Limits...>> = measure_numbers<P, Tuple<Limits...>>;
/// True if each limit of the model follows from functions that return numbers.
template <class P, class Physics>
inline constexpr bool limits_measure_numbers = true;
template <class P, HasLimits Physics>
inline constexpr bool limits_measure_numbers<P, Physics> =
    measure_numbers<P, decltype(std::declval<Physics const&>().limits(Resolution{}))>;
}  // namespace detail

/// A limit from constants of the material and the spacing.
struct ConstantLimit {
  std::string_view name;
  double step = 0;  ///< s

  /// No functions of particles: the limit does not depend on the state.
  static detail::Tuple<> measures() { return {}; }
  /// The limit as the solver compares it.
  TimeStepLimit from(Largest const*) const { return {name, step, TimeStepLimit::never}; }
  /// The limit of each of `steps` steps that use the same rate.
  ConstantLimit over(int steps) const { return {name, step / steps}; }
};
/// A limit of the step.
inline ConstantLimit limit(std::string_view name, double step) { return {name, step}; }

/// A limit from the state: from the largest value of a function of one particle over the material.
template <class Measure, class Step>
struct StateLimit {
  std::string_view name;
  Measure measure;  ///< non-negative; `reads`, operator()(i)
  Step step;        ///< step for that value, s
  int steps = 1;    ///< number of steps that the limit covers

  /// The function of one particle whose largest value decides.
  detail::Tuple<Measure> measures() const { return {measure}; }
  /// The limit for the largest value of its measure.
  TimeStepLimit from(Largest const* largest) const {
    double const longest = step(largest->value);
    // A rare evaluation does not make the state change faster.
    return {name, longest / steps, longest};
  }
  /// The limit of each of `more` steps that use the same rate.
  StateLimit over(int more) const { return {name, measure, step, steps * more}; }
};
/// A limit from the state: `step` returns the longest step (s) for the largest value of `measure`, a function of one
/// particle with `reads`.
template <class Measure, class Step>
StateLimit<Measure, Step> limit(std::string_view name, Measure const& measure, Step const& step) {
  static_assert(
      requires {
        { step(1.0) } -> std::convertible_to<double>;
      },
      "the last argument of limit() is a function of the largest value, which returns a step in s");
  return {name, measure, step};
}

/// The limits for the present state. Throws as check_finite() and stop_beyond() do. One sweep over the particles.
/// `of_body` is the name of the body in messages, if they need it.
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
