// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "text.hpp"
#include "value.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

namespace support {

/// Allowed numbers: [from, to], or (from, to] when `open`.
struct Range {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  bool open = false;

  bool has(double x) const { return (open ? x > from : x >= from) && x <= to; }
  std::string text() const {
    if (std::isinf(from) && std::isinf(to)) return "";
    if (std::isinf(to)) return fmt::format(" {} {}", open ? ">" : ">=", from);
    return fmt::format(" in {}{}, {}]", open ? "(" : "[", from, to);
  }
};

/// Numbers above `from`, up to `to`.
inline Range above(double from, double to = std::numeric_limits<double>::infinity()) { return {from, to, true}; }

/// What a person needs to know about an option. Its default is the member's initialiser in the struct of options.
struct About {
  std::string unit = {};     ///< SI; empty or "1": none
  Range range = {};          ///< of a number, or of each number of an array
  std::string meaning = {};  ///< one line
  std::string unset = {};    ///< std::optional only: what holds when it is not given
};

/// The names of an enumeration are declared beside it, found by its type:
///     constexpr auto names_of(Flux) { return Names<Flux, 2>{{{Flux::symmetric, "symmetric"}, ...}}; }
template <class E, std::size_t N>
using Names = std::array<std::pair<E, std::string_view>, N>;

template <class E>
concept Named = std::is_enum_v<E> && requires(E e) {
  names_of(e).size();
};

/// The name of an enumerator, as the case file spells it.
template <Named E>
std::string name_of(E value) {
  for (auto const& [enumerator, name] : names_of(E{})) {
    if (enumerator == value) return std::string(name);
  }
  return "?";
}

namespace detail {

inline std::string quoted(std::string const& text) {
  std::string all = "\"";
  for (char const c : text) {
    if (c == '"' || c == '\\')
      all += '\\', all += c;
    else if (static_cast<unsigned char>(c) < 32 || c == 127)
      all += fmt::format("\\u{:04x}", static_cast<int>(c));
    else
      all += c;
  }
  return all + '"';
}

inline std::string with_unit(About const& about) {
  return about.unit.empty() || about.unit == "1" ? "" : " " + about.unit;
}

[[noreturn]] inline void refuse_kind(Value const& value, char const* expected) {
  throw Problem{value.where, fmt::format("{} where {} is expected", value.kind(), expected)};
}

}  // namespace detail

/// How values of type V are read, checked, described and written. A type of one's own gets a specialisation.
template <class V>
struct Codec;

template <>
struct Codec<bool> {
  static std::string allowed(About const&) { return "true or false"; }
  static bool read(Value const& value, About const&) {
    if (auto const* found = std::get_if<bool>(&value.data)) return *found;
    detail::refuse_kind(value, "true or false");
  }
  static std::string text(bool value) { return value ? "true" : "false"; }
};

template <>
struct Codec<double> {
  static std::string allowed(About const& about) { return "a number" + about.range.text() + detail::with_unit(about); }
  static double read(Value const& value, About const& about) {
    double number = 0;
    if (auto const* real = std::get_if<double>(&value.data))
      number = *real;
    else if (auto const* whole = std::get_if<std::int64_t>(&value.data))
      number = static_cast<double>(*whole);
    else
      detail::refuse_kind(value, "a number");
    if (!std::isfinite(number)) throw Problem{value.where, fmt::format("{} is not a finite number", number)};
    if (!about.range.has(number)) throw Problem{value.where, fmt::format("{} is out of range", number)};
    return number;
  }
  static std::string text(double value) { return fmt::format("{}", value); }
};

template <std::integral V>
struct Codec<V> {
  static std::string allowed(About const& about) {
    return "an integer" + about.range.text() + detail::with_unit(about);
  }
  static V read(Value const& value, About const& about) {
    auto const* number = std::get_if<std::int64_t>(&value.data);
    if (number == nullptr) detail::refuse_kind(value, "an integer");
    if (!std::in_range<V>(*number) || !about.range.has(static_cast<double>(*number))) {
      throw Problem{value.where, fmt::format("{} is out of range", *number)};
    }
    return static_cast<V>(*number);
  }
  static std::string text(V value) { return fmt::format("{}", value); }
};

template <>
struct Codec<std::string> {
  static std::string allowed(About const&) { return "a text in quotes"; }
  static std::string read(Value const& value, About const&) {
    if (auto const* text = std::get_if<std::string>(&value.data)) return *text;
    detail::refuse_kind(value, "a text in quotes");
  }
  static std::string text(std::string const& value) { return detail::quoted(value); }
};

template <Named E>
struct Codec<E> {
  static std::vector<std::string> names() {
    std::vector<std::string> all;
    for (auto const& named : names_of(E{})) all.emplace_back(named.second);
    return all;
  }
  static std::string allowed(About const&) {
    auto all = names();
    for (auto& name : all) name = detail::quoted(name);
    return join(all);
  }
  static E read(Value const& value, About const&) {
    auto const* text = std::get_if<std::string>(&value.data);
    if (text == nullptr) detail::refuse_kind(value, "a name in quotes");
    for (auto const& [enumerator, name] : names_of(E{})) {
      if (name == *text) return enumerator;
    }
    auto const hint = nearest(*text, names());
    throw Problem{value.where, fmt::format("unknown name {}{}", detail::quoted(*text),
                                           hint.empty() ? "" : ", did you mean " + detail::quoted(hint) + "?")};
  }
  static std::string text(E value) { return detail::quoted(name_of(value)); }
};

template <>
struct Codec<std::vector<double>> {
  static std::string allowed(About const& about) {
    return "an array of numbers, each" + (about.range.text().empty() ? " finite" : about.range.text()) +
           detail::with_unit(about);
  }
  static std::vector<double> read(Value const& value, About const& about) {
    auto const* array = std::get_if<Value::Array>(&value.data);
    if (array == nullptr) detail::refuse_kind(value, "an array of numbers");
    std::vector<double> numbers;
    for (auto const& element : *array) numbers.push_back(Codec<double>::read(element, about));
    return numbers;
  }
  static std::string text(std::vector<double> const& values) { return fmt::format("[{}]", fmt::join(values, ", ")); }
};

/// An option that may be left out; its text is then empty.
template <class V>
struct Codec<std::optional<V>> {
  static std::string allowed(About const& about) { return Codec<V>::allowed(about); }
  static std::optional<V> read(Value const& value, About const& about) { return Codec<V>::read(value, about); }
  static std::string text(std::optional<V> const& value) { return value ? Codec<V>::text(*value) : ""; }
};

}  // namespace support
