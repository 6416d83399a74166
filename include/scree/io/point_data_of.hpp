// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/bodies.hpp"
#include "../fields/records.hpp"
#include "../snapshots/snapshot_columns.hpp"
#include "../system/ghosts.hpp"
#include "derived_field.hpp"
#include "in_space.hpp"
#include "point_columns.hpp"
#include "point_data.hpp"

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

// The values of a list of fields on the particles of a solver, for a writer.
namespace scree {
namespace detail {

template <class List, class Body>
inline constexpr bool carries_all = std::is_same_v<Without<List, typename Body::fields>, Fields<>>;
template <Field F, class Body>
inline constexpr bool carries = carries_all<Fields<F>, Body>;
template <DerivedField F, class Body>
inline constexpr bool carries<F, Body> = carries_all<reads_of<F>, Body>;

/// The type of a field's values on the host; for a derived field, the type that `of` returns.
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
auto host_values(Body const& body, Resolution const&) {
  return body.to_host(F{});
}
template <DerivedField F, class Body>
auto host_values(Body const& body, Resolution const& resolution) {
  using Value = typename host_value<typename Body::policy, F>::type;
  static_assert(!is_expression<Value>,
                "the function `of` of a derived field must return a value, not an expression of Eigen: add .eval()");
  std::vector<Value> values;
  if constexpr (GivesValue<F, typename Body::policy>)
    for (auto const& i : records_of(body, reads_of<F>{})) values.push_back(F::of(i, resolution));
  return values;
}

/// A body, and how its values are put in order.
template <class Body>
struct BodyInOrder {
  using particles = Body;
  Body const& body;
  BodyOfPoints<typename Body::policy::space> points;
};
template <BodyTag Tag, class S>
auto whole_body(S const& solver) {
  auto const whole = solver.template whole<Tag>();
  auto const& body = whole.here();
  auto const in_order = [order = whole.order()](std::vector<std::byte> values, std::size_t of_each) {
    return order.of(std::move(values), of_each);
  };
  return BodyInOrder<std::remove_cvref_t<decltype(body)>>{body, {&body.columns(), std::size_t(whole.size()), in_order}};
}

template <Field F, class Value>
FieldOfPoints field_of_points(int dim) {
  static_assert(components_in_space<F> > 0, "VTK has no arrays for values like those of this field");
  return {prefix_of<F>,
          F::name,
          F::unit,
          form_of<F>,
          components_in_space<F>,
          dim,
          element_type<typename number_of<Value>::type>()};
}

/// Appends the values of a derived field on one body.
template <DerivedField F, class Whole>
void append_derived(PointArray& array, FieldOfPoints const& field, Whole const& whole, Resolution const& resolution) {
  if constexpr (carries<F, typename Whole::particles>) {
    auto const values = host_values<F>(whole.body, resolution);
    constexpr std::size_t each = sizeof(values[0]);
    auto const* const first = reinterpret_cast<std::byte const*>(values.data());
    append_in_space(array, field, whole.points.in_order({first, first + values.size() * each}, each));
  } else {
    append_zeros(array, whole.points.count);
  }
}

template <class P, Field F, class... Whole>
PointArray point_array_of(Resolution const& resolution, std::vector<BodyOfPoints<typename P::space>> const& bodies,
                          Whole const&... whole) {
  static_assert(
      (carries<F, typename Whole::particles> || ...),
      "no body that is written carries this field: a field is carried if a pass reads or writes it there; for "
      "output alone, name a pass that writes it in `diagnostics`");
  auto const field = field_of_points<F, typename host_value<P, F>::type>(P::dim);
  if constexpr (DerivedField<F>) {
    PointArray array = empty_array(field);
    (append_derived<F>(array, field, whole, resolution), ...);
    return array;
  } else {
    return array_of_column<typename P::space>(field, &field_key<F>, bodies);
  }
}

/// Returns an array of the index of each particle's body in the list of all bodies.
template <class All, BodyTag... Tags, class... Whole>
PointArray body_marker(Bodies<Tags...>, Whole const&... whole) {
  std::vector<std::int32_t> numbers;
  (numbers.resize(numbers.size() + whole.points.count, static_cast<std::int32_t>(body_index<Tags, All>())), ...);
  return {"body", 1, std::move(numbers), "1"};
}

}  // namespace detail

/// Returns the current positions and the given fields of bodies, with components in VTK's order (see in_space()). The
/// bodies follow one another, each with its particles in the order of memory; list Identity if the solver sorts
/// particles. If the case has several ranks, all ranks get the particles of all ranks, in the order of their
/// identities. Arrays have the names of the fields, with underscores for blanks. With more than one body, an array
/// `body` holds the index of each particle's body in the `bodies` of the formulation (0: material, 1: wall), and a
/// field is 0 on bodies that do not carry it. Diagnostics are updated first. Rates and other results of passes belong
/// to the last step or, before the first step, to the initial state.
template <class S, class... Fs, BodyTag... Tags>
[[gnu::cold]] PointData point_data_of(S& solver, Fields<Fs...>, Bodies<Tags...> tags) {
  using P = typename S::policy;
  ProfilingRegion const region("scree::point_data");
  if (solver.steps() == 0) solver.update_rates();
  solver.update_diagnostics();
  auto const resolution = solver.resolution();
  PointData data{.time = solver.time()};
  auto const add = [&](auto const&... whole) {
    std::vector<detail::BodyOfPoints<typename P::space>> const bodies = {whole.points...};
    data.xyz = std::get<std::vector<typename P::real>>(
        detail::point_array_of<P, Position>(resolution, bodies, whole...).values);
    (data.arrays.push_back(detail::point_array_of<P, Fs>(resolution, bodies, whole...)), ...);
    if (sizeof...(Tags) > 1) data.arrays.push_back(detail::body_marker<typename P::bodies>(tags, whole...));
  };
  add(detail::whole_body<Tags>(solver)...);
  return data;
}
/// Returns the current positions and the given fields of the material.
template <class S, class... Fs>
PointData point_data_of(S& solver, Fields<Fs...> fields) {
  return point_data_of(solver, fields, Bodies<Material>{});
}

}  // namespace scree
