// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/parameter.hpp"
#include "value.hpp"

#include <array>
#include <concepts>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

namespace scree::app {

/// A range of allowed numbers: [from, to], or (from, to] if `open`.
using Range = ParameterRange;

/// Returns the range of the numbers above `from`, up to and including `to`.
inline Range above(double from, double to = std::numeric_limits<double>::infinity()) { return {from, to, true}; }

/// The description of an option for users. The default of the option is the initialiser of its member in the struct of
/// options.
struct About {
  std::string unit = {};     ///< SI; empty or "1": none
  Range range = {};          ///< allowed range of a number, or of each number in an array
  std::string meaning = {};  ///< meaning in one line
  std::string unset = {};    ///< for a std::optional: the meaning of a missing value
};

/// The names of the values of an enumeration, which a function next to the enumeration returns:
///     constexpr auto names_of(Flux) { return Names<Flux, 2>{{{Flux::symmetric, "symmetric"}, ...}}; }
template <class E, std::size_t N>
using Names = std::array<std::pair<E, std::string_view>, N>;

/// Whether E is an enumeration with names from `names_of`, one of which is then the value of an option.
template <class E>
concept Named = std::is_enum_v<E> && requires(E e) {
  names_of(e).size();
};

/// Returns the name of an enumerator, as spelt in the case file.
template <Named E>
std::string name_of(E value) {
  for (auto const& [enumerator, name] : names_of(E{}))
    if (enumerator == value) return std::string(name);
  return "?";
}

namespace detail {

/// Returns a range as text: " in [0, 1)", " > 0".
std::string text_of(Range const& range);
std::string quoted(std::string_view text);
std::string with_unit(About const& about);
std::string allowed_integers(About const& about);
std::string allowed_names(std::vector<std::string> const& names);
/// Returns an integer. Throws Problem if the value is not allowed, like all functions read_...().
std::int64_t read_integer(Value const& value, About const& about, std::int64_t least, std::int64_t largest);
std::string allowed_array(int count, About const& about);
std::vector<double> read_array(Value const& value, About const& about, int count);
std::size_t read_name(Value const& value, std::vector<std::string> const& names);

}  // namespace detail

/// The functions that read, describe and write values of type V as TOML. To use another type for options, specialise
/// this template.
template <class V>
struct Codec {
  static_assert(sizeof(V) == 0,
                "an option is a bool, an integer, a double, a std::string, a std::vector<double>, a Vec<2, double> or "
                "Vec<3, double>, "
                "an enumeration with a function names_of() next to it, or a std::optional of one of these; for another "
                "type, specialise "
                "scree::app::Codec");
  /// Returns a text that lists the allowed values.
  static std::string allowed(About const& about);
  /// Returns the value of an option from a value in a case file. Throws Problem if the value has another type or is out
  /// of range.
  static V read(Value const& value, About const& about);
  /// Returns a value as TOML.
  static std::string text(V const& value);
};

template <>
struct Codec<bool> {
  static std::string allowed(About const& about);
  static bool read(Value const& value, About const& about);
  static std::string text(bool value);
};
template <>
struct Codec<double> {
  static std::string allowed(About const& about);
  static double read(Value const& value, About const& about);
  static std::string text(double value);
};
template <>
struct Codec<std::string> {
  static std::string allowed(About const& about);
  static std::string read(Value const& value, About const& about);
  static std::string text(std::string const& value);
};
template <>
struct Codec<std::vector<double>> {
  static std::string allowed(About const& about);
  static std::vector<double> read(Value const& value, About const& about);
  static std::string text(std::vector<double> const& value);
};

/// The codec of vectors with a fixed number of components, for instance the parameters of motions.
template <int Dim>
struct Codec<scree::detail::VectorParameter<Dim>> {
  using V = scree::detail::VectorParameter<Dim>;
  static std::string allowed(About const& about) { return detail::allowed_array(Dim, about); }
  static V read(Value const& value, About const& about) {
    auto const numbers = detail::read_array(value, about, Dim);
    V all;
    for (int k = 0; k < Dim; ++k) all[k] = numbers[std::size_t(k)];
    return all;
  }
  static std::string text(V const& value) {
    return Codec<std::vector<double>>::text(std::vector<double>(value.data(), value.data() + Dim));
  }
};

template <std::integral V>
struct Codec<V> {
  static std::string allowed(About const& about) { return detail::allowed_integers(about); }
  static V read(Value const& value, About const& about) {
    using Limits = std::numeric_limits<V>;
    static_assert(sizeof(V) < sizeof(std::int64_t) || std::signed_integral<V>,
                  "unsigned 64-bit options do not fit TOML");
    return static_cast<V>(detail::read_integer(value, about, Limits::min(), Limits::max()));
  }
  static std::string text(V value) { return std::to_string(value); }
};

template <Named E>
struct Codec<E> {
  static std::vector<std::string> names() {
    std::vector<std::string> all;
    for (auto const& named : names_of(E{})) all.emplace_back(named.second);
    return all;
  }
  static std::string allowed(About const&) { return detail::allowed_names(names()); }
  static E read(Value const& value, About const&) { return names_of(E{})[detail::read_name(value, names())].first; }
  static std::string text(E value) { return detail::quoted(name_of(value)); }
};

/// The codec of options that may be left out; the text of a missing value is empty.
template <class V>
struct Codec<std::optional<V>> {
  static std::string allowed(About const& about) { return Codec<V>::allowed(about); }
  static std::optional<V> read(Value const& value, About const& about) { return Codec<V>::read(value, about); }
  static std::string text(std::optional<V> const& value) { return value ? Codec<V>::text(*value) : ""; }
};

}  // namespace scree::app
