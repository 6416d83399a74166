// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "write_file.hpp"

#include <span>
#include <vector>

namespace support {

struct OutputRequest {
  std::filesystem::path directory;
  std::vector<std::string> results;  ///< names of the files the run will write there
  bool force = false;                ///< results of an earlier run may go
};

/// Makes the directory ready before a run starts, so that it does not fail when it is over: creates it, stops when it
/// holds results already (with `force` removes them, so that none is left from another run), and tries to write.
/// Throws std::runtime_error naming the file and the reason.
inline void prepare_output(OutputRequest const& request) {
  namespace fs = std::filesystem;
  auto const& directory = request.directory;
  std::error_code error;
  fs::create_directories(directory, error);
  if (error && !fs::is_directory(directory)) {
    throw std::runtime_error(
        fmt::format("{}: cannot create the output directory: {}", directory.string(), error.message()));
  }
  for (auto const& name : request.results) {
    auto const file = directory / name;
    if (!fs::exists(fs::symlink_status(file, error))) continue;
    if (!request.force) {
      throw std::runtime_error(
          fmt::format("{}: holds an earlier result; give another --output, or --force to replace it", file.string()));
    }
    if (fs::is_directory(file))
      throw std::runtime_error(fmt::format("{}: is a directory, not a result", file.string()));
    if (!fs::remove(file, error)) {
      throw std::runtime_error(fmt::format("{}: cannot replace it: {}", file.string(), error.message()));
    }
  }
  auto const probe = directory / ".can_write";
  write_file(probe, "yes\n");
  fs::remove(probe, error);
}

}  // namespace support
