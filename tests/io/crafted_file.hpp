// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "checkpoint_file.hpp"

#include <functional>

// Checkpoints that were changed on purpose: their seal is intact.
namespace checkpoint_test {

using scree::hdf5::Handle;

/// The content of a checkpoint, open to any change.
struct Content {
  Handle file;

  void remove(std::string const& name) const { H5Ldelete(file, name.c_str(), H5P_DEFAULT); }
  /// Replaces a dataset by one of zeros, or without values; attributes are lost.
  Handle replace(std::string const& name, hid_t type, Handle const& space, Handle const& creation, bool write) const {
    remove(name);
    Handle dataset{H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose};
    std::vector<char> const zeros(write ? H5Tget_size(type) * std::size_t(H5Sget_simple_extent_npoints(space)) : 0);
    if (write) H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros.data());
    return dataset;
  }
  static Handle in_one_piece() { return {H5Pcreate(H5P_DATASET_CREATE), H5Pclose}; }
  static Handle simple(std::vector<hsize_t> const& size) {
    return {H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose};
  }
  void zeros(std::string const& name, hid_t type, std::vector<hsize_t> const& size) const {
    auto const dataset = replace(name, type, simple(size), in_one_piece(), true);
    scree::hdf5::write_text(dataset, "unit", "m/s");
    scree::hdf5::write_text(dataset, "names", "a: b\nneighbour builds/material-wall\nstep limits/sound\n");
  }
  /// Replaces a dataset by one with other properties of its storage.
  void stored(std::string const& name, hid_t type, std::vector<hsize_t> const& size,
              std::function<void(hid_t)> const& change, bool write = true) const {
    auto const creation = in_one_piece();
    change(creation);
    scree::hdf5::write_text(replace(name, type, simple(size), creation, write), "unit", "m/s");
  }
  void attribute(std::string const& object, char const* name, hid_t type, Handle const& space) const {
    Handle const where{H5Oopen(file, object.c_str(), H5P_DEFAULT), H5Oclose};
    H5Adelete(where, name);
    Handle const attribute{H5Acreate2(where, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose};
    std::vector<char> const zeros(H5Tget_size(type) * std::size_t(H5Sget_simple_extent_npoints(space)));
    if (H5Tis_variable_str(type) <= 0) H5Awrite(attribute, type, zeros.data());
  }
  void text_attribute(std::string const& object, char const* name, std::string const& text) const {
    Handle const where{H5Oopen(file, object.c_str(), H5P_DEFAULT), H5Oclose};
    H5Adelete(where, name);
    scree::hdf5::write_text(where, name, text);
  }
};

/// Changes a checkpoint and seals it again.
inline void craft(fs::path const& path, std::function<void(Content const&)> const& change) {
  scree::hdf5::Silence const silence;
  change({{H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose}});
  scree::detail::seal(path);
}

}  // namespace checkpoint_test
