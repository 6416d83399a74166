// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"
#include "../fields/remainder.hpp"
#include "../system/system.hpp"
#include "snapshot.hpp"

#include <cxxabi.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <typeinfo>

// The fields of particles as arrays of a snapshot.
namespace scree {
namespace detail {

/// An array without values.
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

/// Name, unit and type of a column.
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

/// The arrays of a body, without values. Fields with the same name are numbered.
std::vector<SnapshotArray> heads_of(std::string const& body, std::vector<ColumnHead> const& columns);
template <class P, class... Fs>
std::vector<SnapshotArray> heads_of(std::string const& body, Fields<Fs...>) {
  return heads_of(body,
                  {{prefix_of<Fs>, Fs::name, Fs::unit, element_type<typename number_of<value_t<P, Fs>>::type>(),
                    static_cast<int>(sizeof(value_t<P, Fs>) / sizeof(typename number_of<value_t<P, Fs>>::type))}...});
}
/// Calls visit(index of the body, columns, number, head) for all columns of all bodies.
template <class Sys, class Visit>
void for_each_column(Sys& system, Visit const& visit) {
  using P = typename std::remove_const_t<Sys>::policy;
  auto const visit_body = [&](std::size_t body, UntypedParticles<typename P::space> const& columns,
                              std::vector<SnapshotArray> const& heads) {
    for (std::size_t k = 0; k < heads.size(); ++k) visit(body, columns, k, heads[k]);
  };
  for_each_body(typename Sys::bodies{}, [&]<class Body>() {
    auto const& body = system.template body<Body>();
    visit_body(body_index<Body, typename std::remove_const_t<Sys>::bodies>(), body.columns(),
               heads_of<P>(std::string(Body::name), typename std::remove_cvref_t<decltype(body)>::fields{}));
  });
}

/// The `name` of a class. A class without one has its name in C++, with namespaces and arguments; a class of scree
/// itself has it without both.
template <class T>
std::string name_of_class() {
  if constexpr (requires { std::string_view(T::name); }) {
    return std::string(T::name);
  } else {
    char* const readable = abi::__cxa_demangle(typeid(T).name(), nullptr, nullptr, nullptr);
    std::string const whole = readable == nullptr ? typeid(T).name() : readable, own = "scree::";
    std::free(readable);
    std::string const short_name = whole.substr(0, whole.find('<'));
    bool const is_own = short_name.starts_with(own) && short_name.find("::", own.size()) == std::string::npos;
    return is_own ? short_name.substr(own.size()) : whole;
  }
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
