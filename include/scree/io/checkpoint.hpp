// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/writes_files.hpp"
#include "checkpoint_snapshot.hpp"

// A checkpoint is a snapshot in an HDF5 file, sealed with its size and a checksum. See docs/checkpoint.md.
namespace scree {

/// Returns the path at which write_checkpoint() keeps the previous checkpoint: "out/checkpoint.h5" ->
/// "out/checkpoint.previous.h5".
inline std::filesystem::path previous_checkpoint(std::filesystem::path const& path) {
  auto const name = path.stem().string() + ".previous" + path.extension().string();
  return path.parent_path() / name;
}

namespace detail {

template <class Action>
auto with_file_named(std::filesystem::path const& path, char const* what, Action action) {
  hdf5::Silence const silence;
  std::string cause;
  try {
    return action();
  } catch (hdf5::Failure const& failure) {
    cause = failure.what();
  } catch (std::filesystem::filesystem_error const& failure) {
    cause = failure.code().message();
  } catch (std::system_error const& failure) {
    cause = failure.code().message();
  }
  throw std::runtime_error(fmt::format("{}: cannot {}: {}", path.string(), what, cause));
}

/// Throws hdf5::Failure if a path exists and is not a regular file: opening a pipe would block.
inline void check_regular(std::filesystem::path const& path) {
  if (std::filesystem::exists(path) && !std::filesystem::is_regular_file(path))
    throw hdf5::Failure("it is not a regular file");
}

inline std::filesystem::path with_suffix(std::filesystem::path path, char const* suffix) { return path += suffix; }

/// A temporary file that is deleted unless it has been renamed to its final name.
struct TemporaryFile {
  std::filesystem::path path;
  explicit TemporaryFile(std::filesystem::path const& whole) : path(with_suffix(whole, ".part")) {}
  TemporaryFile(TemporaryFile const&) = delete;
  TemporaryFile& operator=(TemporaryFile const&) = delete;
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
};

/// Gives a checkpoint the name previous_checkpoint() by a hard link, so that its own name never disappears. On a file
/// system without hard links, renames the checkpoint.
inline void keep_as_previous(std::filesystem::path const& path) {
  auto const previous = previous_checkpoint(path);
  TemporaryFile const link(previous);
  std::error_code without_links;
  std::filesystem::remove(link.path);  // left by a run that was killed here
  std::filesystem::create_hard_link(path, link.path, without_links);
  std::filesystem::rename(without_links ? path : link.path, previous);
}

}  // namespace detail

/// Replaces a checkpoint with a newer one and keeps the older one as previous_checkpoint(). At any time, even if the
/// program is killed or the disk is full, at least one of the two is complete. The directory must exist. Throws
/// std::runtime_error with the file and the reason. Does nothing on ranks other than the first (core/writes_files.hpp).
inline void write_checkpoint(std::filesystem::path const& path, Snapshot const& snapshot) {
  if (!writes_files()) return;
  detail::with_file_named(path, "write the checkpoint", [&] {
    detail::check_regular(path);
    detail::TemporaryFile const part(path);
    detail::write_snapshot(part.path, snapshot);
    detail::seal(part.path);
    if (std::filesystem::exists(path)) detail::keep_as_previous(path);
    std::filesystem::rename(part.path, path);
    auto const directory = path.parent_path().empty() ? std::filesystem::path(".") : path.parent_path();
    detail::FileDescriptor(directory, O_RDONLY).sync();
  });
}

/// Returns the snapshot in a checkpoint. Throws std::runtime_error with the file and the reason if the file is damaged
/// or is not a checkpoint of this format; the previous checkpoint, if there is one, may then be used instead.
inline Snapshot read_checkpoint(std::filesystem::path const& path) {
  return detail::with_file_named(path, "read the checkpoint", [&] {
    detail::check_regular(path);
    detail::check_seal(path);
    return detail::read_snapshot(path);
  });
}

}  // namespace scree
