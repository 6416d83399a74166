// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../checks/set_values.hpp"
#include "../checks/start.hpp"
#include "../fields/bodies.hpp"
#include "../formulation/explain_set.hpp"
#include "../system/periodic.hpp"
#include "../system/pick.hpp"
#include "unset_fields.hpp"

#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
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
/// Returns a value, or a function of the point (m), as the value of a field for Solver::add().
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
  for ([[maybe_unused]] X const& x : points) {
    if constexpr (!explain_given<P, F, X, Value>())
      break;
    else if constexpr (std::is_convertible_v<Value, value_t<P, F>>)
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

/// Whether added particles need a value for a field: nothing else provides one, and zero is unlikely to be intended.
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
/// The fields for which added particles need a value and have none; the list must be empty.
template <class P, class Body, class... Fs>
using fields_not_given =
    Without<typename fields_to_give<P, Body, body_fields<P, Body>>::type, Fields<Fs..., Identity, Position, Volume>>;

/// Reports a formulation whose particles can be neither added nor removed, because several bodies evolve.
template <class P>
constexpr bool explain_population() {
  constexpr bool one = !several_evolve<P>;
  static_assert(
      one, "particles are added, removed and let through inlets, drains and open ends only where one body evolves");
  return one;
}
template <class P, class... Fs>
constexpr void static_check_given() {
  static_assert(std::is_same_v<fields_not_given<P, Material, Fs...>, Fields<>>,
                "particles that are added need a value of each field that passes read and nothing computes: "
                "given(field, value)");
  static_assert(!OneOf<Group, fields_to_move<P, Material>>,
                "the material follows a motion by group: no particles can be added");
}
/// The condition that a particle, or one of its periodic images, is in a box.
template <class X>
struct NearBox {
  using reads = Fields<Position>;
  X low, high, period;  // m; a period of 0: none
  template <class I>
  SCREE_FN bool operator()(I const& i) const {
    for (int axis = 0; axis < X::RowsAtCompileTime; ++axis) {
      auto const x = i[fields::position][axis], L = period[axis];
      bool near = x >= low[axis] && x <= high[axis];
      if (L > 0)
        near = near || (x + L >= low[axis] && x + L <= high[axis]) || (x - L >= low[axis] && x - L <= high[axis]);
      if (!near) return false;
    }
    return true;
  }
};
/// Returns the condition that a particle is within a distance (m) of the box around some points.
template <class X>
NearBox<X> near_to(std::vector<X> const& points, double distance, std::vector<Period> const& periods) {
  NearBox<X> near{points.front(), points.front(), zero<X>()};
  for (X const& x : points) near.low = near.low.cwiseMin(x), near.high = near.high.cwiseMax(x);
  near.low.array() -= typename X::Scalar(distance), near.high.array() += typename X::Scalar(distance);
  for (Period const& each : periods) near.period[each.axis] = typename X::Scalar(each.high - each.low);
  return near;
}
/// Returns the volumes of new particles, m^dim: the given values, or spacing^dim if none are given.
template <class P, class X, class... Fs, class... Values>
std::vector<typename P::real> volumes_at(std::vector<X> const& points, double spacing,
                                         Given<Fs, Values> const&... values) {
  std::vector<typename P::real> volumes(points.size(), typename P::real(std::pow(spacing, P::dim)));
  [[maybe_unused]] auto const take = [&](auto field, auto const& value) {
    if constexpr (std::is_same_v<decltype(field), Volume>) volumes = values_at<P>(points, value);
  };
  (take(Fs{}, values), ...);
  check_volumes(volumes, "those that are added");
  return volumes;
}
/// Throws std::invalid_argument if new particles of the material would overlap with each other or with particles of any
/// body, or if their distances or volumes (m^dim) do not fit the spacing. Walls and rigid bodies are checked first,
/// with the words `at_walls`, so that an overlap with them is not reported as one with material that is there, too. The
/// message names new particles by their indices and others by their identities.
template <class Sys, class Settings, class X, class V>
[[gnu::cold]] void check_added(Sys const& system, Settings const& settings, std::vector<X> const& points,
                               std::vector<V> const& volumes, StartWords const& words, StartWords at_walls) {
  constexpr int dim = Sys::policy::dim;
  PlacedParticles placed;
  placed.add(points, 0.0);
  placed.volumes.assign(volumes.begin(), volumes.end());
  placed.numbers = numbers_from(0, points);
  auto const near = near_to(points, 3 * settings.spacing, settings.periods);
  auto const check = [&](StartWords words_of_it) {
    words_of_it.judges_packing = false;
    check_start(placed, points.size(), settings.spacing, dim, settings.periods, words_of_it);
  };
  auto const add = [&]<class Body>() {
    auto const whole = system.template whole<Body>();
    auto const picked = pick(whole.here(), near);
    placed.add(whole.untyped(), picked);
    auto const identities = whole.order(picked).of(whole.here().to_host(fields::identity, picked));
    placed.numbers.insert(placed.numbers.end(), identities.begin(), identities.end());
  };
  at_walls.may_be_sparse = true;  // there may be material around the new particles
  for_each_body(typename Sys::bodies{}, [&]<class Body>() {
    if constexpr (!std::is_same_v<Body, Material>) {
      std::size_t const before = placed.places.size();
      add.template operator()<Body>();
      if (placed.places.size() == before) return;
      std::string const of_others = " of the " + std::string(Body::name);
      at_walls.of_others = of_others.c_str();
      check(at_walls);
    }
  });
  add.template operator()<Material>();
  check(words);
  if (words.may_be_sparse) return;
  // Only the new particles are checked here: those that are already there may be loosely packed.
  placed.places.resize(points.size()), placed.volumes.resize(points.size()), placed.numbers.resize(points.size());
  Packing const packing = packing_of(placed, points.size(), settings.spacing, dim, settings.periods);
  if (!packing.can_tell()) return;
  auto const fault = fault_of_packing(packing, settings.spacing, dim, words.when);
  if (!fault.empty()) throw std::invalid_argument(fault + "; if this is meant, set `start_checks = false`");
}
/// Adds particles with the given volumes (m^dim) to the material, with identities from `number` on. Returns the sum of
/// the volumes.
template <class Sys, class X, class V, class... Fs, class... Values>
double append(Sys& system, int number, std::vector<X> const& points, std::vector<V> const& volumes,
              Given<Fs, Values> const&... values) {
  using namespace fields;
  using Basis = typename Sys::policy;
  auto const columns = std::tuple(values_at<Basis>(points, values)...);
  auto& all = system.template body<Material>();
  int const first = system.template append<Material>(static_cast<int>(points.size()));
  bool const here = system.whole_case().takes_new();
  [[maybe_unused]] auto const set_one = [&](auto field, auto const& column) {
    if (here) all.from_host(field, column, first);
  };
  set_one(position, points);
  set_one(identity, numbers_from(number, points));
  std::apply([&](auto const&... column) { (set_one(Fs{}, column), ...); }, columns);
  if (here) all.from_host(volume, volumes, first);
  return std::accumulate(volumes.begin(), volumes.end(), 0.0);
}

}  // namespace detail
}  // namespace scree
