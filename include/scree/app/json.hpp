// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace scree::app {

/// A JSON value: a number, a text, a Boolean, an array, or an object that is given as pairs of name and value:
///     Json::Object{{"scheme", "hcsr"}, {"steps", 1200}, {"mean_C", 0.5}, {"compared", Json::Array{20, 40.5}}}
struct Json {
  using Array = std::vector<Json>;
  using Object = std::vector<std::pair<std::string, Json>>;

  /// Creates a Boolean.
  Json(bool value) : data(value) {}
  /// Creates a number from an integer.
  Json(std::integral auto value) : data(static_cast<std::int64_t>(value)) {}
  /// Creates a number.
  Json(std::floating_point auto value) : data(static_cast<double>(value)) {}
  /// Creates a text.
  Json(char const* value) : data(std::string(value)) {}
  /// Creates a text.
  Json(std::string value) : data(std::move(value)) {}
  /// Creates an array.
  Json(Array value) : data(std::move(value)) {}
  /// Creates an object.
  Json(Object value) : data(std::move(value)) {}

  std::variant<bool, std::int64_t, double, std::string, Array, Object> data;
};

/// Returns an object as JSON text, with sorted names and all digits of numbers. NaN and infinity, which JSON does not
/// have, become the texts "NaN" and "Infinity". Implemented in toml.cpp.
std::string to_json(Json::Object const& object);

}  // namespace scree::app
