// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"
#include "../fields/remainder.hpp"
#include "../system/system.hpp"
#include "snapshot.hpp"

#include <cstdio>
#include <cstring>
#include <string_view>
#include <typeinfo>

// The fields of particles as arrays of a snapshot.
namespace scree {
namespace detail {

/// Returns an array without values.
template <class T>
SnapshotArray head_of(std::string name, std::string unit) {
  using number = typename number_of<T>::type;
  static_assert(sizeof(T) % sizeof(number) == 0);
  return {std::move(name), std::move(unit), element_type<number>(), static_cast<int>(sizeof(T) / sizeof(number)), {}};
}
template <class T>
SnapshotArray filled(SnapshotArray head, std::vector<T> const& values) {
  auto const* const first = reinterpret_cast<std::byte const*>(values.data());
  head.bytes.assign(first, first + values.size() * sizeof(T));
  return head;
}
template <class T>
std::vector<T> values_of(SnapshotArray const& array) {
  std::vector<T> values(array.bytes.size() / sizeof(T));
  if (!values.empty()) std::memcpy(static_cast<void*>(values.data()), array.bytes.data(), array.bytes.size());
  return values;
}

/// The name, unit and type of a column.
struct ColumnHead {
  std::string_view prefix, name, unit;
  ElementType element;
  int components;
};
template <class F>
inline constexpr std::string_view prefix_of = "";
template <class F>
inline constexpr std::string_view prefix_of<Previous<F>> = "previous ";
template <class F>
inline constexpr std::string_view prefix_of<Remainder<F>> = "remainder of ";

/// Returns the arrays of a body without values. Fields with the same name are numbered.
std::vector<SnapshotArray> heads_of(std::string const& body, std::vector<ColumnHead> const& columns);
template <class P, class... Fs>
std::vector<SnapshotArray> heads_of(std::string const& body, Fields<Fs...>) {
  return heads_of(body,
                  {{prefix_of<Fs>, Fs::name, Fs::unit, element_type<typename number_of<value_t<P, Fs>>::type>(),
                    static_cast<int>(sizeof(value_t<P, Fs>) / sizeof(typename number_of<value_t<P, Fs>>::type))}...});
}
/// A body for a snapshot, as untyped columns.
template <class Space>
struct BodyOfSnapshot {
  std::string name;
  UntypedParticles<Space> const* columns;
  std::vector<SnapshotArray> heads;  // arrays of the columns, without values
  Turnover turnover;
  long at_start;  // number of particles on all ranks at the start
};
template <class Space>
using BodiesOfSnapshot = std::vector<BodyOfSnapshot<Space>>;
/// Returns the bodies of a system in its order. The result refers to the system.
template <class Sys>
[[gnu::cold]] auto bodies_of_snapshot(Sys const& system) {
  using P = typename Sys::policy;
  BodiesOfSnapshot<typename P::space> bodies;
  for_each_body(typename Sys::bodies{}, [&]<class Body>() {
    auto const& body = system.template body<Body>();
    auto const& turnover = system.template turnover<Body>();
    std::string const name(Body::name);
    bodies.push_back({name, &body.columns(), heads_of<P>(name, typename std::remove_cvref_t<decltype(body)>::fields{}),
                      turnover, turnover.at_start(system.template whole<Body>().size())});
  });
  return bodies;
}

std::string name_of_class(std::type_info const& type);
/// Returns the `name` of a class, or its C++ name if it has no `name`. The C++ name includes namespaces and template
/// arguments, except for classes directly in the namespace scree.
template <class T>
std::string name_of_class() {
  if constexpr (requires { std::string_view(T::name); })
    return std::string(T::name);
  else
    return name_of_class(typeid(T));
}
inline std::string exact_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

}  // namespace detail
}  // namespace scree

#ifndef SCREE_COMPILED
#include "snapshot_columns.ipp"
#endif
