// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/bodies.hpp"
#include "../fields/records.hpp"
#include "../snapshots/snapshot_columns.hpp"
#include "../system/ghosts.hpp"
#include "derived_field.hpp"
#include "in_space.hpp"
#include "point_data.hpp"

#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

// The particles of a solver as numbers for a writer, by a list of fields.
namespace scree {
namespace detail {

template <class List, class Body>
inline constexpr bool carries_all = std::is_same_v<Without<List, typename Body::fields>, Fields<>>;
template <Field F, class Body>
inline constexpr bool carries = carries_all<Fields<F>, Body>;
template <DerivedField F, class Body>
inline constexpr bool carries<F, Body> = carries_all<reads_of<F>, Body>;

/// The value of a field on the host; of a derived field, what `of` returns.
template <class P, Field F>
struct host_value {
  using type = value_t<P, F>;
};
template <class F, class P>
concept GivesValue = requires(Record<P, reads_of<F>> const& i) {
  F::of(i, Resolution{});
};
template <class F, bool Gives>
constexpr void explain_derived() {
  static_assert(Gives, "a derived field needs a static function of(i, resolution)");
}
template <class P, DerivedField F>
struct host_value<P, F> {
  static constexpr auto find() {
    explain_derived<F, GivesValue<F, P>>();
    if constexpr (GivesValue<F, P>)
      return std::type_identity<decltype(F::of(std::declval<Record<P, reads_of<F>> const&>(), Resolution{}))>{};
    else
      return std::type_identity<double>{};
  }
  using type = typename decltype(find())::type;
};

template <Field F, class Body>
auto host_values(Body const& body, Resolution const& resolution) {
  if constexpr (DerivedField<F>) {
    using Value = typename host_value<typename Body::policy, F>::type;
    static_assert(!is_expression<Value>,
                  "the function `of` of a derived field must return a value, not an expression of Eigen: add .eval()");
    std::vector<Value> values;
    if constexpr (GivesValue<F, typename Body::policy>)
      for (auto const& i : records_of(body, reads_of<F>{})) values.push_back(F::of(i, resolution));
    return values;
  } else {
    return body.to_host(F{});
  }
}

/// The particles of a body, all of them in one order.
template <class Body, class Order>
struct BodyInOrder {
  using particles = Body;
  Body const& body;
  Order order;
  std::size_t count;
};
template <class Body, class Order>
BodyInOrder(Body const&, Order, std::size_t) -> BodyInOrder<Body, Order>;
template <BodyTag Tag, class S>
auto whole_body(S const& solver) {
  auto const whole = solver.template whole<Tag>();
  return BodyInOrder{whole.here(), whole.order(), std::size_t(whole.size())};
}

/// Adds the numbers of one body to those of others; zeros where it does not carry the field.
template <Field F, class Number, class Whole>
void append_numbers(std::vector<Number>& numbers, Whole const& whole, Resolution const& resolution) {
  using Body = typename Whole::particles;
  if constexpr (carries<F, Body>) {
    for (auto const& value : whole.order.of(host_values<F>(whole.body, resolution))) {
      auto const all = in_space<Body::policy::dim, F>(value);
      numbers.insert(numbers.end(), all.begin(), all.end());
    }
  } else {
    numbers.resize(numbers.size() + whole.count * components_in_space<F>, 0);
  }
}

/// The name of a field without blanks, which calculators of arrays do not take.
template <Field F>
std::string array_name() {
  std::string name = std::string(prefix_of<F>) + std::string(F::name);
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

/// The unit of a field, with the number of dimensions in place of "dim".
template <class P, Field F>
std::string array_unit() {
  std::string unit(F::unit);
  if (auto const at = unit.find("dim"); at != std::string::npos) unit.replace(at, 3, std::to_string(P::dim));
  return unit;
}

template <class P, Field F, class... Whole>
PointArray point_array_of(Resolution const& resolution, Whole const&... whole) {
  static_assert(
      (carries<F, typename Whole::particles> || ...),
      "no body that is written carries this field: a field is carried if a pass reads or writes it there; for "
      "output alone, name a pass that writes it in `diagnostics`");
  using Number = typename number_of<typename host_value<P, F>::type>::type;
  std::vector<Number> numbers;
  (append_numbers<F>(numbers, whole, resolution), ...);
  return {array_name<F>(), components_in_space<F>, std::move(numbers), array_unit<P, F>()};
}

/// The index of the body of each particle in the list of all bodies.
template <class All, BodyTag... Tags, class... Whole>
PointArray body_marker(Bodies<Tags...>, Whole const&... whole) {
  std::vector<std::int32_t> numbers;
  (numbers.resize(numbers.size() + whole.count, static_cast<std::int32_t>(body_index<Tags, All>())), ...);
  return {"body", 1, std::move(numbers), "1"};
}

}  // namespace detail

/// Positions and the given fields of bodies now, with components in VTK's order (see in_space()). The bodies come one
/// behind the other, each in the order of its particles in memory; list Identity where a solver sorts them. The
/// particles of several ranks come in the order of their identities, on all ranks. Arrays have the names of the fields,
/// with underscores. With more than one body there is an array `body`, the index of each in the `bodies` of the
/// formulation (0: material, 1: wall), and a field is 0 on the bodies that do not carry it. Diagnostics are brought up
/// to date first. Rates and other results of passes belong to the last step; before the first step, to the
/// initial state.
template <class S, class... Fs, BodyTag... Tags>
[[gnu::cold]] PointData point_data_of(S& solver, Fields<Fs...>, Bodies<Tags...> bodies) {
  using P = typename S::policy;
  ProfilingRegion const region("scree::point_data");
  if (solver.steps() == 0) solver.update_rates();
  solver.update_diagnostics();
  auto const resolution = solver.resolution();
  PointData data{.time = solver.time()};
  auto const add = [&](auto const&... whole) {
    std::vector<typename P::real> xyz;
    (detail::append_numbers<Position>(xyz, whole, resolution), ...);
    data.xyz = std::move(xyz);
    (data.arrays.push_back(detail::point_array_of<P, Fs>(resolution, whole...)), ...);
    if (sizeof...(Tags) > 1) data.arrays.push_back(detail::body_marker<typename P::bodies>(bodies, whole...));
  };
  add(detail::whole_body<Tags>(solver)...);
  return data;
}
/// Positions and the given fields of the material.
template <class S, class... Fs>
PointData point_data_of(S& solver, Fields<Fs...> fields) {
  return point_data_of(solver, fields, Bodies<Material>{});
}

}  // namespace scree
