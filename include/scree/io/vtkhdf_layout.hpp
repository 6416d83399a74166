// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "hdf5_table.hpp"
#include "point_field.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace scree {

/// Options of VTKHDF files.
struct VtkHdfOptions {
  bool overwrite = false;         ///< replace an existing file
  bool single_precision = false;  ///< store positions and double fields as 32-bit floats
  int deflate = 0;                ///< zlib level: 0 (off, fastest) to 9
  /// Names and texts of the attributes of the group /scree: version, command line, case file, ... A text that is too
  /// long for an attribute (60 kB) becomes a dataset of the group.
  std::vector<std::pair<std::string, std::string>> provenance = {};
};

/// The layout of the numbers in the file, according to VTK's "VTKHDF File Format" specification, version 2.0.
namespace detail {

inline constexpr std::array<char const*, 4> cell_groups = {"Vertices", "Lines", "Polygons", "Strips"};  // VTK's order

/// The position of the next step, in rows. A part is VTK's unit of topology; consecutive steps with equal n share one.
struct StepPosition {
  std::size_t index = 0;
  double time = 0;
  std::int64_t point = 0;      // first row in Points and PointData
  std::int64_t part = -1;      // the part that holds the vertices
  std::int64_t cell = 0;       // first vertex of this part
  std::int64_t part_size = 0;  // number of vertices in this part

  void begin_part(std::int64_t n) {
    cell += part_size;
    ++part;
    part_size = n;
  }
};

/// Returns the number of rows in a chunk: a whole step or, if that exceeds 32768 rows, an equal share of it, so that no
/// chunk is written (and compressed) twice while n stays the same. Steps of fewer than 256 rows share chunks.
inline std::size_t chunk_rows(std::size_t n) {
  constexpr std::size_t least = 256, most = 32768;
  auto const shares = (n + most - 1) / most;
  return std::max(least, shares == 0 ? 0 : (n + shares - 1) / shares);
}

/// Returns an upper bound on the bytes that a step adds to the file; `rows` includes a chunk that is not filled.
inline std::uintmax_t bytes_of_rows(std::size_t rows, std::span<PointField const> fields) {
  constexpr std::size_t metadata = 1 << 18, metadata_of_field = 1 << 13, vertex = 16, position = 24, number = 8;
  std::size_t row = vertex + position;
  for (auto const& field : fields) row += number * static_cast<std::size_t>(field.components);
  return metadata + metadata_of_field * fields.size() + row * (rows + 1);
}
inline constexpr std::uintmax_t bytes_of_empty_series = 1 << 18;

inline void write_number_of_steps(hid_t steps, std::size_t number, bool create = false) {
  auto const value = static_cast<std::int64_t>(number);
  hdf5::Handle const attribute{
      hdf5::check(create ? H5Acreate2(steps, "NSteps", H5T_STD_I64LE, hdf5::scalar_space(), H5P_DEFAULT, H5P_DEFAULT)
                         : H5Aopen(steps, "NSteps", H5P_DEFAULT)),
      H5Aclose};
  hdf5::check(H5Awrite(attribute, H5T_NATIVE_INT64, &value));
}

inline void write_provenance(hid_t where, std::string const& name, std::string const& text) {
  constexpr std::size_t longest_attribute = 60'000;  // HDF5's limit is 64 KiB for all that describes one
  if (text.size() <= longest_attribute) return hdf5::write_text(where, name, text);
  hdf5::Handle const type = hdf5::text_type(text);
  hdf5::Handle const dataset{hdf5::check(H5Dcreate2(where, name.c_str(), type, hdf5::scalar_space(), H5P_DEFAULT,
                                                    hdf5::without_times(), H5P_DEFAULT)),
                             H5Dclose};
  hdf5::check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()));
}

/// Writes the part of the file that depends neither on n nor on the fields.
inline void create_groups(hid_t file) {
  hdf5::Handle const root = hdf5::create_group(file, "VTKHDF");
  hsize_t const two = 2;
  std::array<std::int64_t, 2> const version = {2, 0};
  hdf5::Handle const space{hdf5::check(H5Screate_simple(1, &two, nullptr)), H5Sclose};
  hdf5::Handle const attribute{hdf5::check(H5Acreate2(root, "Version", H5T_STD_I64LE, space, H5P_DEFAULT, H5P_DEFAULT)),
                               H5Aclose};
  hdf5::check(H5Awrite(attribute, H5T_NATIVE_INT64, version.data()));
  hdf5::write_text(root, "Type", "PolyData");

  for (char const* name : {"PointData", "CellData", "FieldData"}) hdf5::create_group(root, name);
  for (char const* name : cell_groups) hdf5::create_group(root, name);
  hdf5::Handle const steps = hdf5::create_group(root, "Steps");
  hdf5::create_group(steps, "PointDataOffsets");
  write_number_of_steps(steps, 0, true);
}

struct TableOptions {
  std::size_t chunk_rows;
  hid_t real;  ///< HDF5 type of stored positions
  VtkHdfOptions const* options;
};

inline hid_t stored_real(bool is_double, bool single_precision) {
  return is_double && !single_precision ? H5T_IEEE_F64LE : H5T_IEEE_F32LE;
}
inline hid_t stored_type(PointField const& field, bool single_precision) {
  if (std::holds_alternative<std::span<std::int32_t const>>(field.values)) return H5T_STD_I32LE;
  return stored_real(std::holds_alternative<std::span<double const>>(field.values), single_precision);
}

/// Writes the unit of a field as an attribute for readers that use HDF5; VTK ignores it.
inline void write_unit(hid_t where, PointField const& field) {
  if (field.unit.empty()) return;
  hdf5::Handle const table{hdf5::check(H5Dopen2(where, field.name.c_str(), H5P_DEFAULT)), H5Dclose};
  if (hdf5::check(H5Aexists(table, "units")) == 0) hdf5::write_text(table, "units", field.unit);
}

inline void create_tables(hid_t root, std::span<PointField const> fields, TableOptions const& settings) {
  auto const& [rows, real, options] = settings;
  hdf5::TableFormat const position{.type = real, .columns = 3, .chunk_rows = rows, .deflate = options->deflate};
  hdf5::TableFormat index = position, counter{.type = H5T_STD_I64LE}, offset{.type = H5T_STD_I64LE, .columns = 4};
  hdf5::TableFormat const time{.type = H5T_IEEE_F64LE};
  index.type = H5T_STD_I64LE;
  index.columns = 0;

  hdf5::create_table(root, "Points", position);
  hdf5::create_table(root, "NumberOfPoints", counter);
  for (char const* name : cell_groups) {
    hdf5::Handle const group = hdf5::open_group(root, name);
    auto const& table = name == cell_groups[0] ? index : counter;
    for (char const* count : {"NumberOfCells", "NumberOfConnectivityIds"}) hdf5::create_table(group, count, counter);
    for (char const* list : {"Connectivity", "Offsets"}) hdf5::create_table(group, list, table);
  }
  hdf5::create_table(root, "Steps/Values", time);
  for (char const* name : {"PartOffsets", "NumberOfParts", "PointOffsets"}) {
    hdf5::create_table(hdf5::open_group(root, "Steps"), name, counter);
  }
  hdf5::create_table(root, "Steps/CellOffsets", offset);
  hdf5::create_table(root, "Steps/ConnectivityIdOffsets", offset);
  for (auto const& field : fields) {
    hdf5::TableFormat table = position;
    table.type = stored_type(field, options->single_precision);
    table.columns = field.components == 1 ? 0 : static_cast<hsize_t>(field.components);
    hdf5::Handle const data = hdf5::open_group(root, "PointData");
    hdf5::create_table(data, field.name.c_str(), table);
    write_unit(data, field);
    hdf5::create_table(hdf5::open_group(root, "Steps/PointDataOffsets"), field.name.c_str(), counter);
  }
}

/// Writes one row of a table of counters.
inline void write_numbers(hid_t where, char const* name, std::int64_t row,
                          std::initializer_list<std::int64_t> numbers) {
  hdf5::write_rows(where, name, static_cast<hsize_t>(row),
                   std::span<std::int64_t const>(numbers.begin(), numbers.size()));
}

/// Writes the vertices of a new part: one cell per particle, and an entry without cells in each of the other groups.
inline void write_part(hid_t root, StepPosition const& step) {
  std::vector<std::int64_t> ids(static_cast<std::size_t>(step.part_size) + 1);
  std::iota(ids.begin(), ids.end(), 0);
  std::span<std::int64_t const> const offsets(ids);
  write_numbers(root, "NumberOfPoints", step.part, {step.part_size});
  for (char const* name : cell_groups) {
    hdf5::Handle const group = hdf5::open_group(root, name);
    bool const used = name == cell_groups[0];
    auto const cells = used ? step.part_size : 0;
    write_numbers(group, "NumberOfCells", step.part, {cells});
    write_numbers(group, "NumberOfConnectivityIds", step.part, {cells});
    // In every part, Offsets has one more entry than there are cells.
    auto const first = static_cast<hsize_t>((used ? step.cell : 0) + step.part);
    hdf5::write_rows(group, "Offsets", first, offsets.first(static_cast<std::size_t>(cells) + 1));
    if (used) hdf5::write_rows(group, "Connectivity", static_cast<hsize_t>(step.cell), offsets.first(ids.size() - 1));
  }
}

inline void write_particles(hid_t root, std::int64_t first_row, PointCoordinates const& xyz,
                            std::span<PointField const> fields) {
  auto const row = static_cast<hsize_t>(first_row);
  std::visit([&](auto const& values) { hdf5::write_rows(root, "Points", row, values); }, xyz);
  hdf5::Handle const data = hdf5::open_group(root, "PointData");
  for (auto const& field : fields) {
    std::visit([&](auto const& values) { hdf5::write_rows(data, field.name.c_str(), row, values); }, field.values);
  }
}

/// Makes the step visible to readers. NSteps is written last, because readers rely on it.
inline void write_step_entry(hid_t root, StepPosition const& step, std::span<PointField const> fields) {
  hdf5::Handle const steps = hdf5::open_group(root, "Steps");
  auto const row = static_cast<std::int64_t>(step.index);
  hdf5::write_rows(steps, "Values", step.index, std::span<double const>(&step.time, 1));
  write_numbers(steps, "PartOffsets", row, {step.part});
  write_numbers(steps, "NumberOfParts", row, {1});
  write_numbers(steps, "PointOffsets", row, {step.point});
  write_numbers(steps, "CellOffsets", row, {step.cell, 0, 0, 0});
  write_numbers(steps, "ConnectivityIdOffsets", row, {step.cell, 0, 0, 0});
  hdf5::Handle const data = hdf5::open_group(steps, "PointDataOffsets");
  for (auto const& field : fields) write_numbers(data, field.name.c_str(), row, {step.point});
  write_number_of_steps(steps, step.index + 1);
}

}  // namespace detail
}  // namespace scree
