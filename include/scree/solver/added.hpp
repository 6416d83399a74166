// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "start.hpp"
#include "unset_fields.hpp"

#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <type_traits>
#include <vector>

// The values of particles that are added during a run.
namespace scree {

/// The value of a field, or a function of the point (m) that returns it.
template <Field F, class Value>
struct Given {
  Value value;
};
/// For Solver::add().
template <Field F, class Value>
Given<F, Value> given(F, Value const& value) {
  static_assert(!detail::is_expression<Value>,
                "the value given to add() must be a value, not an expression of Eigen: add .eval() to it");
  return {value};
}

namespace detail {

template <class P, class F, class Value, class X>
std::vector<value_t<P, F>> values_at(std::vector<X> const& points, Given<F, Value> const& given) {
  std::vector<value_t<P, F>> values;
  values.reserve(points.size());
  for (X const& x : points) {
    if constexpr (std::is_convertible_v<Value, value_t<P, F>>)
      values.push_back(value_t<P, F>(given.value));
    else
      values.push_back(value_t<P, F>(given.value(x)));
  }
  return values;
}
template <class X>
std::vector<int> numbers_from(long first, std::vector<X> const& points) {
  std::vector<int> numbers(points.size());
  std::iota(numbers.begin(), numbers.end(), static_cast<int>(first));
  return numbers;
}

/// Whether particles that are added need a value of a field: nothing else gives it, and zero is hardly meant.
template <class P, class Body, class F>
inline constexpr bool must_be_given = std::is_same_v<F, Group> ||
                                      (!may_begin_at_zero<F, evolved_fields<typename P::physics::evolves>> &&
                                       !OneOf<F, written_fields<P, Body>>);
template <class P, class Body, class List>
struct fields_to_give;
template <class P, class Body, class... Fs>
struct fields_to_give<P, Body, Fields<Fs...>> {
  using type = Merge<std::conditional_t<must_be_given<P, Body, Fs>, Fields<Fs>, Fields<>>...>;
};
/// Fields without a value for added particles: an error unless it is empty.
template <class P, class Body, class... Fs>
using fields_not_given =
    Without<typename fields_to_give<P, Body, body_fields<P, Body>>::type, Fields<Fs..., Identity, Position, Volume>>;

/// Throws std::invalid_argument if new particles of the material would overlap with each other or with those of any
/// body.
template <class Sys, class Settings, class X>
[[gnu::cold]] void check_added(Sys const& system, Settings const& settings, std::vector<X> const& points) {
  using Basis = typename Sys::policy;
  constexpr int dim = Basis::dim;
  Particles<Basis, Fields<Position, Volume>> added(static_cast<int>(points.size()));
  added.from_host(position, points);
  added.fill(volume, typename Basis::real(std::pow(settings.spacing, dim)));
  PlacedParticles placed;
  placed.add(added);
  for_each_body(typename Sys::bodies{}, [&]<class Body>() { placed.add(system.template body<Body>()); });
  check_start(placed, points.size(), settings.spacing, dim, settings.periods,
              {"among those to be added,", " of those that are there"});
}
/// Adds particles to the material, numbered from `number`, with the volume spacing^dim unless that is given.
template <class Sys, class Settings, class X, class... Fs, class... Values>
void append(Sys& system, Settings const& settings, int number, std::vector<X> const& points,
            Given<Fs, Values> const&... values) {
  using Basis = typename Sys::policy;
  using real = typename Basis::real;
  auto const columns = std::tuple(values_at<Basis>(points, values)...);
  int const first = system.template append<Material>(static_cast<int>(points.size()));
  auto& all = system.template body<Material>();
  all.from_host(position, points, first);
  all.from_host(identity, numbers_from(number, points), first);
  all.from_host(volume, std::vector<real>(points.size(), real(std::pow(settings.spacing, Basis::dim))), first);
  std::apply([&](auto const&... column) { (all.from_host(Fs{}, column, first), ...); }, columns);
}

}  // namespace detail
}  // namespace scree
