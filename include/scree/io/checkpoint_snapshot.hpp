// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "checkpoint_reader.hpp"

namespace scree::detail {

/// Returns an upper bound on the size (bytes) of a snapshot in a file.
inline std::uintmax_t bytes_of(Snapshot const& snapshot) {
  constexpr std::uintmax_t metadata = 1 << 18, metadata_of_entry = 1 << 12;
  std::uintmax_t bytes = metadata + snapshot.signature.size();
  for (auto const& array : snapshot.arrays) bytes += metadata_of_entry + array.bytes.size();
  for (auto const& [name, text] : snapshot.notes) bytes += metadata_of_entry + name.size() + text.size();
  for (auto const& [name, count] : snapshot.counters) bytes += sizeof(count) + 2 * name.size();
  return bytes;
}

inline void write_content(hid_t file, Snapshot const& snapshot) {
  write_text_dataset(file, "signature", snapshot.signature);
  hdf5::write_text(write_numbers_of(file, "time", std::vector<double>{snapshot.time}), "unit", "s");
  write_numbers_of(file, "steps", std::vector<std::int64_t>{snapshot.steps});

  std::vector<std::string> names;
  std::vector<std::int64_t> counts;
  for (auto const& [name, count] : snapshot.counters) names.push_back(name), counts.push_back(count);
  hdf5::write_text(write_numbers_of(file, "counters", counts), "names", joined(names));

  names.clear();
  hdf5::Handle const notes = hdf5::create_group(file, "notes");
  for (auto const& [name, text] : snapshot.notes) names.push_back(name), write_text_dataset(notes, name, text);
  hdf5::write_text(notes, "names", joined(names));

  names.clear();
  hdf5::Handle const arrays = hdf5::create_group(file, "arrays");
  for (auto const& array : snapshot.arrays) names.push_back(array.name), write_array(arrays, array);
  hdf5::write_text(arrays, "names", joined(names));
}

/// Throws hdf5::Failure if HDF5 cannot store a name or text of the notes, or a name of an array.
inline void check_entries(Snapshot const& snapshot) {
  std::vector<std::string> arrays;
  for (auto const& array : snapshot.arrays) arrays.push_back(array.name);
  for (auto const& fault : {fault_of_notes(snapshot.notes), fault_of_names(arrays, "arrays")})
    if (!fault.empty()) throw hdf5::Failure(fault);
}

/// Writes a snapshot to a file without a seal. Throws hdf5::Failure or std::system_error.
inline void write_snapshot(std::filesystem::path const& path, Snapshot const& snapshot) {
  check_entries(snapshot);
  // HDF5 should not run into a full disk, so space is reserved before it writes.
  FileDescriptor(path, O_WRONLY | O_CREAT | O_TRUNC);
  reserve_disk_space(path, bytes_of(snapshot));
  hdf5::Handle const access = hdf5::without_locks();
  hdf5::Handle const creation{hdf5::check(H5Pcreate(H5P_FILE_CREATE)), H5Pclose};
  hdf5::check(H5Pset_userblock(creation, seal_size));
  hdf5::Handle empty{hdf5::check(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, access)), H5Fclose};
  hdf5::check(empty.close());
  // H5Fcreate() has emptied the file, so space is reserved again; HDF5 then reopens the file, uses the space and
  // releases the rest.
  reserve_disk_space(path, bytes_of(snapshot));
  hdf5::Handle file{hdf5::check(H5Fopen(path.c_str(), H5F_ACC_RDWR, access)), H5Fclose};
  write_content(file, snapshot);
  hdf5::check(file.close());
}

/// Returns the snapshot in a file whose seal is intact.
inline Snapshot read_snapshot(std::filesystem::path const& path) {
  CheckpointReader file(path);
  Snapshot snapshot;
  snapshot.signature = file.text("signature");
  snapshot.time = file.numbers<double>("time", 1).front();
  snapshot.steps = static_cast<long>(file.numbers<std::int64_t>("steps", 1).front());
  auto const names = file.names("counters");
  auto const counts = file.numbers<std::int64_t>("counters", names.size());
  for (std::size_t k = 0; k < names.size(); ++k) snapshot.counters[names[k]] = static_cast<long>(counts[k]);
  for (auto const& name : file.names("notes")) snapshot.notes[name] = file.text("notes/" + name);
  for (auto const& name : file.names("arrays")) snapshot.arrays.push_back(file.array("arrays", name));
  snapshot.origin = path.string();
  return snapshot;
}

}  // namespace scree::detail
