// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "../fields/particles.hpp"
#include "../snapshots/snapshot.hpp"
#include "in_space.hpp"
#include "point_data.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

// Fields for a writer as bytes without C++ types, so that the same functions gather the numbers of all fields.
namespace scree::detail {

/// The description of an array of a field.
struct FieldOfPoints {
  std::string_view prefix, name, unit;
  Form form;
  int components, dim;  // `dim`: dimensions of the simulation
  ElementType element;
};

/// A body: its columns, the number of its particles on all ranks, and a function that arranges values of a given size
/// (bytes) in the order of all its particles.
template <class Space>
struct BodyOfPoints {
  UntypedParticles<Space> const* columns;
  std::size_t count;
  std::function<std::vector<std::byte>(std::vector<std::byte>, std::size_t)> in_order;
};

/// Returns the array of a field without its values. Blanks in the name are replaced, because array calculators do not
/// accept them; "dim" in the unit is replaced by the number of dimensions.
PointArray empty_array(FieldOfPoints const& field);
/// Appends values, given as raw bytes, with all the components that they have in 3D.
void append_in_space(PointArray& array, FieldOfPoints const& field, std::vector<std::byte> const& values);
/// Appends zeros for particles that do not carry the field.
void append_zeros(PointArray& array, std::size_t particles);

/// Returns the values of a stored field on all bodies; `key` is the field_key of the field.
template <class Space>
[[gnu::cold]] PointArray array_of_column(FieldOfPoints const& field, void const* key,
                                         std::vector<BodyOfPoints<Space>> const& bodies) {
  PointArray array = empty_array(field);
  for (auto const& body : bodies) {
    auto const& columns = *body.columns;
    if (auto const k = columns.find(key); k < columns.kinds()) {
      std::size_t const each = columns.bytes_of(k);
      std::vector<std::byte> values(std::size_t(columns.size()) * each);
      columns.to_host(k, values.data());
      append_in_space(array, field, body.in_order(std::move(values), each));
    } else {
      append_zeros(array, body.count);
    }
  }
  return array;
}

}  // namespace scree::detail

#ifdef SCREE_COMPILED
SCREE_INSTANCE scree::PointArray scree::detail::array_of_column(
    scree::detail::FieldOfPoints const&, void const*,
    std::vector<scree::detail::BodyOfPoints<Kokkos::DefaultExecutionSpace>> const&);
#else
#include "point_columns.ipp"
#endif
