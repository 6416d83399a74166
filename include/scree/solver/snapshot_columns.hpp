// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "snapshot.hpp"
#include "system.hpp"

#include <cxxabi.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <typeinfo>

// The fields of particles as arrays of a snapshot.
namespace scree {
namespace detail {

template <class T>
struct number_of {
  using type = T;
};
template <class T>
requires requires { typename T::Scalar; }
struct number_of<T> {
  using type = typename T::Scalar;
};

template <class F>
struct name_in_snapshot {
  static std::string get() { return std::string(F::name); }
};
template <class F>
struct name_in_snapshot<Previous<F>> {
  static std::string get() { return "previous " + std::string(F::name); }
};

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

/// Calls visit(field, head of its array) for each field of a body. Fields of one name are told apart by their number.
template <class P, class... Fs, class Visit>
void for_each_field(std::string const& body, Fields<Fs...>, Visit const& visit) {
  [[maybe_unused]] std::map<std::string, int> times;
  [[maybe_unused]] auto const name = [&](std::string const& own) {
    int const number = ++times[own];
    return body + "/" + own + (number == 1 ? "" : " (" + std::to_string(number) + ")");
  };
  (visit(Fs{}, head_of<value_t<P, Fs>>(name(name_in_snapshot<Fs>::get()), std::string(Fs::unit))), ...);
}
/// Calls visit(body, field, head) for all fields of both bodies.
template <class Sys, class Visit>
void for_each_column(Sys& system, Visit const& visit) {
  auto const visit_body = [&](std::string const& name, auto& body) {
    using Body = std::remove_cvref_t<decltype(body)>;
    for_each_field<typename Body::policy>(name, typename Body::fields{},
                                          [&](auto field, SnapshotArray head) { visit(body, field, std::move(head)); });
  };
  visit_body("material", system.template body<Material>());
  visit_body("wall", system.template body<Wall>());
}

/// The name of a class without its namespaces and arguments.
template <class T>
std::string class_name() {
  char* const readable = abi::__cxa_demangle(typeid(T).name(), nullptr, nullptr, nullptr);
  std::string name = readable == nullptr ? typeid(T).name() : readable;
  std::free(readable);
  name = name.substr(0, name.find('<'));
  std::size_t const colon = name.rfind("::");
  return colon == std::string::npos ? name : name.substr(colon + 2);
}
inline std::string exact_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

}  // namespace detail
}  // namespace scree
