// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "point_columns.hpp"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>
#include <variant>

namespace scree::detail {

template <int Dim, Form form, class Value, class Number>
void append_placed(std::vector<Number>& numbers, std::vector<std::byte> const& bytes) {
  Value value;
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(Value)) {
    std::memcpy(static_cast<void*>(&value), bytes.data() + at, sizeof(Value));
    auto const all = placed_in_space<Dim, form>(value);
    numbers.insert(numbers.end(), all.begin(), all.end());
  }
}
template <int Dim, class Number>
void append_form(std::vector<Number>& numbers, Form form, std::vector<std::byte> const& bytes) {
  if (form == Form::number) return append_placed<Dim, Form::number, Number>(numbers, bytes);
  if constexpr (std::is_floating_point_v<Number>) {
    if (form == Form::vector) return append_placed<Dim, Form::vector, Vec<Dim, Number>>(numbers, bytes);
    if (form == Form::tensor) return append_placed<Dim, Form::tensor, Mat<Dim, Number>>(numbers, bytes);
    if (form == Form::symmetric3)
      return append_placed<Dim, Form::symmetric3, Vec<symmetric3_size<Dim>, Number>>(numbers, bytes);
    append_placed<Dim, Form::symmetric, Vec<symmetric_size<Dim>, Number>>(numbers, bytes);
  }
}

SCREE_BODY PointArray empty_array(FieldOfPoints const& field) {
  std::string name = std::string(field.prefix) + std::string(field.name), unit(field.unit);
  std::replace(name.begin(), name.end(), ' ', '_');
  if (auto const at = unit.find("dim"); at != std::string::npos) unit.replace(at, 3, std::to_string(field.dim));
  PointArray array{std::move(name), field.components, {}, std::move(unit)};
  if (field.element == ElementType::float32) array.values = std::vector<float>();
  if (field.element == ElementType::int32) array.values = std::vector<std::int32_t>();
  return array;
}

SCREE_BODY void append_in_space(PointArray& array, FieldOfPoints const& field, std::vector<std::byte> const& values) {
  std::visit(
      [&](auto& numbers) {
        if (field.dim == 2)
          append_form<2>(numbers, field.form, values);
        else
          append_form<3>(numbers, field.form, values);
      },
      array.values);
}

SCREE_BODY void append_zeros(PointArray& array, std::size_t particles) {
  std::visit(
      [&](auto& numbers) {
        numbers.resize(numbers.size() + particles * static_cast<std::size_t>(array.components), 0);
      },
      array.values);
}

}  // namespace scree::detail
