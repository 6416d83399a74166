// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/io/hdf5_table.hpp>

#include <catch2/catch_test_macros.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

// Not within the class: nvcc 13 does not come to an end where a class that checks stands before other headers.
inline void require_in_file(std::string const& name, bool is_true) {
  INFO(name);
  REQUIRE(is_true);
}

/// An HDF5 file as a test reads it: whole tables and attributes by name; a missing entry fails the test.
struct File {
  scree::hdf5::Handle id;
  explicit File(std::filesystem::path const& path) : id(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose) {
    require_in_file(path.string(), id >= 0);
  }

  scree::hdf5::Handle table(std::string const& name) const {
    scree::hdf5::Handle found{H5Dopen2(id, name.c_str(), H5P_DEFAULT), H5Dclose};
    require_in_file(name, found >= 0);
    return found;
  }
  std::vector<hsize_t> shape(std::string const& name) const {
    auto const dataset = table(name);
    scree::hdf5::Handle const space{H5Dget_space(dataset), H5Sclose};
    std::vector<hsize_t> size(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, size.data(), nullptr);
    return size;
  }
  template <class T>
  std::vector<T> read(std::string const& name) const {
    hsize_t count = 1;
    for (auto const size : shape(name)) count *= size;
    std::vector<T> values(count);
    if (count > 0)
      require_in_file(
          name, H5Dread(table(name), scree::hdf5::native<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
    return values;
  }
  std::vector<std::int64_t> counts(std::string const& name) const { return read<std::int64_t>("VTKHDF/" + name); }

  bool stored_as(std::string const& name, hid_t type) const {
    scree::hdf5::Handle const found{H5Dget_type(table(name)), H5Tclose};
    return H5Tequal(found, type) > 0;
  }
  scree::hdf5::Handle attribute(char const* object, char const* name) const {
    scree::hdf5::Handle found{H5Aopen_by_name(id, object, name, H5P_DEFAULT, H5P_DEFAULT), H5Aclose};
    require_in_file(name, found >= 0);
    return found;
  }
  std::string text(char const* object, char const* name) const {
    auto const found = attribute(object, name);
    scree::hdf5::Handle const type{H5Aget_type(found), H5Tclose};
    require_in_file(name, H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0);
    std::string value(H5Tget_size(type), '\0');
    H5Aread(found, type, value.data());
    return value;
  }
  std::vector<std::int64_t> numbers(char const* object, char const* name) const {
    auto const found = attribute(object, name);
    scree::hdf5::Handle const space{H5Aget_space(found), H5Sclose};
    std::vector<std::int64_t> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    H5Aread(found, H5T_NATIVE_INT64, values.data());
    return values;
  }
};
