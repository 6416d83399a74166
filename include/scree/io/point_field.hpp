// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

namespace scree {

/// One quantity of n particles: n * components numbers, particle by particle.
struct PointField {
  std::string name;    ///< the name in ParaView; must not be empty or contain '/' or '.'
  int components = 1;  ///< 1: scalar, 3: vector, 6: symmetric tensor, 9: full tensor
  std::variant<std::span<double const>, std::span<float const>, std::span<std::int32_t const>> values;
  std::string unit = {};  ///< written as the attribute `units` unless empty
};
/// The positions of n particles: 3 n coordinates, particle by particle.
using PointCoordinates = std::variant<std::span<double const>, std::span<float const>>;

namespace detail {

using FieldLayout = std::tuple<std::string, int, std::size_t>;  // name, components, number type of a field

inline std::size_t size_of(auto const& numbers) {
  return std::visit([](auto const& values) { return values.size(); }, numbers);
}

inline std::vector<FieldLayout> columns_of(std::span<PointField const> fields) {
  std::vector<FieldLayout> columns;
  for (auto const& field : fields) columns.emplace_back(field.name, field.components, field.values.index());
  return columns;
}

/// Returns the names of fields in alphabetical order.
inline std::vector<std::string> names_of(std::span<PointField const> fields) {
  std::set<std::string> names;
  for (auto const& field : fields) names.insert(field.name);
  return {names.begin(), names.end()};
}

/// Returns a description of the error in the fields of n particles, or an empty text if there is none.
inline std::string fault_of(std::span<PointField const> fields, std::size_t n) {
  std::set<std::string> names;
  for (auto const& [name, components, values, unit] : fields) {
    if (name.empty() || name.find_first_of("/.") != std::string::npos) {
      return fmt::format("'{}' is no name for a field: it is empty or has a '/' or '.'", name);
    }
    if (!names.insert(name).second) return fmt::format("two fields are called '{}'", name);
    if (components < 1) return fmt::format("field '{}' has {} components", name, components);
    auto const size = size_of(values);
    auto const wanted = n * static_cast<std::size_t>(components);
    if (size != wanted) return fmt::format("field '{}' has {} values instead of {}", name, size, wanted);
  }
  return {};
}

}  // namespace detail
}  // namespace scree
