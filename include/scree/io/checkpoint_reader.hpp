// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "checkpoint_layout.hpp"

#include <fmt/format.h>

#include <array>
#include <set>

namespace scree::detail {

template <class Action>
auto named(std::string const& entry, Action const& action) {
  try {
    return action();
  } catch (hdf5::Failure const& failure) {
    throw hdf5::Failure("'" + entry + "': " + failure.what());
  }
}

/// A reader of the entries of an untrusted file. It checks the type, rank and size of each entry before it allocates
/// memory. All functions throw an hdf5::Failure that names the entry.
class CheckpointReader {
 public:
  explicit CheckpointReader(std::filesystem::path const& path) : unread_(std::filesystem::file_size(path)) {
    hdf5::Handle const access = hdf5::without_locks();
    file_ = {hdf5::check(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access)), H5Fclose};
  }

  std::string text(std::string const& name) {
    return named(name, [&] {
      hdf5::Handle const dataset = open(name), type{hdf5::check(H5Dget_type(dataset)), H5Tclose};
      hdf5::Handle const space{hdf5::check(H5Dget_space(dataset)), H5Sclose};
      std::string text = room_for_text(type, space);
      check_stored(dataset, text.size());
      hdf5::check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()));
      return without_padding(std::move(text));
    });
  }
  std::string text_attribute(std::string const& object, char const* name) {
    return named(object + "/" + name, [&] {
      check_links(object);
      hdf5::Handle const attribute{hdf5::check(H5Aopen_by_name(file_, object.c_str(), name, H5P_DEFAULT, H5P_DEFAULT)),
                                   H5Aclose};
      hdf5::Handle const type{hdf5::check(H5Aget_type(attribute)), H5Tclose};
      hdf5::Handle const space{hdf5::check(H5Aget_space(attribute)), H5Sclose};
      std::string text = room_for_text(type, space);
      hdf5::check(H5Aread(attribute, type, text.data()));
      return without_padding(std::move(text));
    });
  }
  /// Returns the lines of the attribute "names". Throws hdf5::Failure if a line occurs twice.
  std::vector<std::string> names(std::string const& object) {
    auto const all = lines_of(text_attribute(object, "names"));
    if (std::set<std::string>(all.begin(), all.end()).size() != all.size())
      throw hdf5::Failure("'" + object + "': a name occurs twice");
    return all;
  }
  template <class T>
  std::vector<T> numbers(std::string const& name, std::size_t count) {
    return named(name, [&] {
      hdf5::Handle const dataset = open(name), type{hdf5::check(H5Dget_type(dataset)), H5Tclose};
      if (hdf5::check(H5Tequal(type, hdf5::native<T>())) == 0) throw hdf5::Failure("its numbers have another type");
      auto const size = extents<1>(dataset)[0];
      if (size != count) throw hdf5::Failure(fmt::format("it has {} values instead of {}", size, count));
      check_stored(dataset, claimed(count, sizeof(T)));
      std::vector<T> numbers(count);
      if (count > 0) hdf5::check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()));
      return numbers;
    });
  }
  SnapshotArray array(std::string const& group, std::string const& name) {
    SnapshotArray array{name, text_attribute(group + "/" + name, "unit"), ElementType::float64, 1, {}};
    named(group + "/" + name, [&] {
      hdf5::Handle const dataset = open(group + "/" + name);
      array.element = element_of(dataset);
      auto const [count, components] = extents<2>(dataset);
      if (components < 1 || components > most_components)
        throw hdf5::Failure(fmt::format("it has {} numbers for each particle", components));
      array.components = static_cast<int>(components);
      array.bytes.resize(claimed(count, array.bytes_of_each()));
      check_stored(dataset, array.bytes.size());
      if (count > 0)
        hdf5::check(H5Dread(dataset, native_type(array.element), H5S_ALL, H5S_ALL, H5P_DEFAULT, array.bytes.data()));
    });
    return array;
  }

 private:
  static constexpr hsize_t most_components = 1 << 16;

  /// Throws hdf5::Failure unless every link in a name is a hard link: other links may leave the file or never end.
  void check_links(std::string const& name) const {
    for (std::size_t end = 0; end != std::string::npos;) {
      end = name.find('/', end + 1);
      H5L_info_t info;
      hdf5::check(H5Lget_info(file_, name.substr(0, end).c_str(), &info, H5P_DEFAULT));
      if (info.type != H5L_TYPE_HARD) throw hdf5::Failure("it is a link to another place");
    }
  }
  /// Opens a dataset. Throws hdf5::Failure if its storage is not contiguous in this file (external, virtual,
  /// compressed).
  hdf5::Handle open(std::string const& name) const {
    check_links(name);
    hdf5::Handle dataset{hdf5::check(H5Dopen2(file_, name.c_str(), H5P_DEFAULT)), H5Dclose};
    hdf5::Handle const creation{hdf5::check(H5Dget_create_plist(dataset)), H5Pclose};
    if (H5Pget_layout(creation) != H5D_CONTIGUOUS || hdf5::check(H5Pget_external_count(creation)) != 0)
      throw hdf5::Failure("it does not lie in one piece in this file");
    return dataset;
  }
  template <int Rank>
  static std::array<hsize_t, Rank> extents(hid_t dataset) {
    hdf5::Handle const space{hdf5::check(H5Dget_space(dataset)), H5Sclose};
    int const rank = hdf5::check(H5Sget_simple_extent_ndims(space));
    if (H5Sget_simple_extent_type(space) != H5S_SIMPLE || rank != Rank)
      throw hdf5::Failure(fmt::format("it has {} dimensions instead of {}", rank, Rank));
    std::array<hsize_t, Rank> extents{};
    hdf5::check(H5Sget_simple_extent_dims(space, extents.data(), nullptr));
    return extents;
  }
  static ElementType element_of(hid_t dataset) {
    hdf5::Handle const type{hdf5::check(H5Dget_type(dataset)), H5Tclose};
    for (auto const element : {ElementType::float32, ElementType::float64, ElementType::int32})
      if (hdf5::check(H5Tequal(type, stored_type(element))) > 0) return element;
    throw hdf5::Failure("its numbers are neither float32 nor float64 nor int32");
  }
  std::string room_for_text(hid_t type, hid_t space) {
    if (H5Tget_class(type) != H5T_STRING || hdf5::check(H5Tis_variable_str(type)) != 0)
      throw hdf5::Failure("it is no text of fixed length");
    if (H5Sget_simple_extent_type(space) != H5S_SCALAR) throw hdf5::Failure("it is more than one text");
    return std::string(claimed(H5Tget_size(type), 1), '\0');
  }
  static std::string without_padding(std::string text) { return text == std::string(1, '\0') ? "" : text; }
  /// Throws hdf5::Failure unless all values of a dataset are stored: HDF5 would make up values that were never written.
  static void check_stored(hid_t dataset, std::size_t bytes) {
    if (auto const stored = H5Dget_storage_size(dataset); stored != bytes)
      throw hdf5::Failure(fmt::format("{} bytes of it are in the file instead of {}", stored, bytes));
  }
  /// Returns the size of an entry in bytes. Throws hdf5::Failure if all entries so far would be larger than the file.
  std::size_t claimed(std::size_t count, std::size_t bytes_of_each) {
    if (count > unread_ / bytes_of_each) throw hdf5::Failure("it is larger than the file");
    unread_ -= count * bytes_of_each;
    return count * bytes_of_each;
  }

  hdf5::Handle file_;
  std::uintmax_t unread_;  // bytes
};

}  // namespace scree::detail
