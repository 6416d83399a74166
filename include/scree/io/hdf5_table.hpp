// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "hdf5.hpp"

#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

/// Growing tables in an HDF5 file: chunked datasets [rows] or [rows, columns] with an unlimited number of rows.
namespace scree::hdf5 {

/// Returns HDF5's identifier of a C++ number type in memory.
template <class T>
hid_t native() {
  if constexpr (std::is_same_v<T, double>)
    return H5T_NATIVE_DOUBLE;
  else if constexpr (std::is_same_v<T, float>)
    return H5T_NATIVE_FLOAT;
  else if constexpr (std::is_same_v<T, std::int32_t>)
    return H5T_NATIVE_INT32;
  else {
    static_assert(std::is_same_v<T, std::int64_t>, "scree writes double, float, int32 and int64");
    return H5T_NATIVE_INT64;
  }
}

/// The storage format of a table.
struct TableFormat {
  hid_t type;               ///< HDF5 type of a stored number
  hsize_t columns = 0;      ///< 0: a dataset of rank one
  hsize_t chunk_rows = 64;  ///< rows stored (and compressed) together
  int deflate = 0;          ///< zlib level 0 (off) to 9
};

/// Creates an empty table, unless a table of that name exists.
inline void create_table(hid_t where, char const* name, TableFormat const& format) {
  if (check(H5Lexists(where, name, H5P_DEFAULT)) > 0) return;
  int const rank = format.columns == 0 ? 1 : 2;
  hsize_t const none[2] = {0, format.columns};
  hsize_t const unlimited[2] = {H5S_UNLIMITED, format.columns};
  hsize_t const chunk[2] = {format.chunk_rows, format.columns};
  Handle const space{check(H5Screate_simple(rank, none, unlimited)), H5Sclose};
  Handle const creation = without_times();
  check(H5Pset_chunk(creation, rank, chunk));
  if (format.deflate > 0) {
    check(H5Pset_shuffle(creation));
    check(H5Pset_deflate(creation, static_cast<unsigned>(format.deflate)));
  }
  Handle const table{check(H5Dcreate2(where, name, format.type, space, H5P_DEFAULT, creation, H5P_DEFAULT)), H5Dclose};
}

/// Writes `values` as the rows from `first_row` to the end of the table. Existing rows are replaced, so a write that
/// failed half-way can be repeated.
template <class T>
void write_rows(hid_t where, char const* name, hsize_t first_row, std::span<T const> values) {
  Handle const table{check(H5Dopen2(where, name, H5P_DEFAULT)), H5Dclose};
  hsize_t size[2] = {0, 1};
  int const rank = [&] {
    Handle const space{check(H5Dget_space(table)), H5Sclose};
    return check(H5Sget_simple_extent_dims(space, size, nullptr));
  }();
  hsize_t const start[2] = {first_row, 0};
  hsize_t const count[2] = {values.size() / size[1], size[1]};
  size[0] = first_row + count[0];
  check(H5Dset_extent(table, size));
  if (values.empty()) return;

  Handle const file_space{check(H5Dget_space(table)), H5Sclose};
  check(H5Sselect_hyperslab(file_space, H5S_SELECT_SET, start, nullptr, count, nullptr));
  // HDF5 copies number by number if the ranks of the dataspaces differ.
  Handle const memory_space{check(H5Screate_simple(rank, count, nullptr)), H5Sclose};
  check(H5Dwrite(table, native<T>(), memory_space, file_space, H5P_DEFAULT, values.data()));
}

/// Returns all numbers of a table, row by row.
template <class T>
std::vector<T> read_rows(hid_t where, char const* name) {
  Handle const table{check(H5Dopen2(where, name, H5P_DEFAULT)), H5Dclose};
  Handle const space{check(H5Dget_space(table)), H5Sclose};
  std::vector<T> numbers(static_cast<std::size_t>(check(H5Sget_simple_extent_npoints(space))));
  if (!numbers.empty()) check(H5Dread(table, native<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()));
  return numbers;
}

/// Removes all rows of a table after the first `rows`.
inline void cut_rows(hid_t table, hsize_t rows) {
  hsize_t size[2] = {0, 1};
  {
    Handle const space{check(H5Dget_space(table)), H5Sclose};
    check(H5Sget_simple_extent_dims(space, size, nullptr));
  }
  size[0] = std::min(size[0], rows);
  check(H5Dset_extent(table, size));
}

}  // namespace scree::hdf5
