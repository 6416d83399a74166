// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../snapshots/snapshot.hpp"
#include "checkpoint_seal.hpp"
#include "disk_space.hpp"
#include "hdf5_table.hpp"

// The layout of a snapshot in an HDF5 file:
//   /signature, /notes/<name>      texts
//   /time (s), /steps, /counters   numbers; the counters' names are an attribute
//   /arrays/<name>                 [count, components], with the attribute "unit"
namespace scree::detail {

inline std::string joined(std::vector<std::string> const& names) {
  std::string text;
  for (auto const& name : names) {
    if (name.empty() || name.find('\n') != std::string::npos)
      throw hdf5::Failure("'" + name + "' is no name: it is empty or has a line break");
    text += name + "\n";
  }
  if (text.size() > most_bytes_of_names)
    throw hdf5::Failure(
        fmt::format("{} names have {} bytes, at most {} are allowed", names.size(), text.size(), most_bytes_of_names));
  return text;
}
inline hid_t stored_type(ElementType element) {
  if (element == ElementType::int32) return H5T_STD_I32LE;
  return element == ElementType::float64 ? H5T_IEEE_F64LE : H5T_IEEE_F32LE;
}
inline hid_t native_type(ElementType element) {
  if (element == ElementType::int32) return H5T_NATIVE_INT32;
  return element == ElementType::float64 ? H5T_NATIVE_DOUBLE : H5T_NATIVE_FLOAT;
}
inline hdf5::Handle text_type(std::size_t size) {
  hdf5::Handle type{hdf5::check(H5Tcopy(H5T_C_S1)), H5Tclose};
  hdf5::check(H5Tset_cset(type, H5T_CSET_UTF8));
  hdf5::check(H5Tset_size(type, size == 0 ? 1 : size));
  hdf5::check(H5Tset_strpad(type, H5T_STR_NULLPAD));
  return type;
}

/// Creates a dataset and the groups that its name contains, as in "group/name".
inline hdf5::Handle create_dataset(hid_t where, std::string const& name, hid_t type, hid_t space) {
  hdf5::Handle const links{hdf5::check(H5Pcreate(H5P_LINK_CREATE)), H5Pclose};
  hdf5::check(H5Pset_create_intermediate_group(links, 1));
  hdf5::Handle const creation = hdf5::without_times();
  return {hdf5::check(H5Dcreate2(where, name.c_str(), type, space, links, creation, H5P_DEFAULT)), H5Dclose};
}

inline void write_text_dataset(hid_t where, std::string const& name, std::string const& text) {
  hdf5::Handle const type = text_type(text.size());
  hdf5::Handle const dataset = create_dataset(where, name, type, hdf5::scalar_space());
  hdf5::check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()));
}

template <class T>
hdf5::Handle write_numbers_of(hid_t where, char const* name, std::vector<T> const& numbers) {
  hsize_t const size = numbers.size();
  hdf5::Handle const space{hdf5::check(H5Screate_simple(1, &size, nullptr)), H5Sclose};
  hdf5::Handle dataset = create_dataset(where, name, hdf5::native<T>(), space);
  if (size > 0) hdf5::check(H5Dwrite(dataset, hdf5::native<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()));
  return dataset;
}

inline void write_array(hid_t where, SnapshotArray const& array) {
  hsize_t const shape[2] = {array.count(), static_cast<hsize_t>(array.components)};
  hdf5::Handle const space{hdf5::check(H5Screate_simple(2, shape, nullptr)), H5Sclose};
  hdf5::Handle const dataset = create_dataset(where, array.name, stored_type(array.element), space);
  hdf5::write_text(dataset, "unit", array.unit);
  if (!array.bytes.empty())
    hdf5::check(H5Dwrite(dataset, native_type(array.element), H5S_ALL, H5S_ALL, H5P_DEFAULT, array.bytes.data()));
}

}  // namespace scree::detail
