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

/// A JSON value: a number, a text, true or false, an array, or an object given as pairs of name and value:
///     Json::Object{{"scheme", "hcsr"}, {"steps", 1200}, {"mean_C", 0.5}, {"compared", Json::Array{20, 40.5}}}
struct Json {
  using Array = std::vector<Json>;
  using Object = std::vector<std::pair<std::string, Json>>;

  /// Takes true or false.
  Json(bool value) : data(value) {}
  /// Takes an integer.
  Json(std::integral auto value) : data(static_cast<std::int64_t>(value)) {}
  /// Takes a number.
  Json(std::floating_point auto value) : data(static_cast<double>(value)) {}
  /// Takes a text.
  Json(char const* value) : data(std::string(value)) {}
  /// Takes a text.
  Json(std::string value) : data(std::move(value)) {}
  /// Takes an array.
  Json(Array value) : data(std::move(value)) {}
  /// Takes an object.
  Json(Object value) : data(std::move(value)) {}

  std::variant<bool, std::int64_t, double, std::string, Array, Object> data;
};

/// The object as JSON text, with sorted names and all digits. JSON has no NaN or infinity: they become the texts "NaN"
/// and "Infinity". Implemented in toml.cpp.
std::string to_json(Json::Object const& object);

}  // namespace scree::app
