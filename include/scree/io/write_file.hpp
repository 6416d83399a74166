// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/writes_files.hpp"

#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace scree {

/// Throws std::runtime_error with the reason of the last system call: "FILE: cannot WHAT: No space left on device".
[[noreturn]] inline void fail_with_errno(std::filesystem::path const& file, std::string_view what) {
  auto const reason = errno == 0 ? std::string("unknown reason") : std::generic_category().message(errno);
  throw std::runtime_error(file.string() + ": cannot " + std::string(what) + ": " + reason);
}

/// Replaces the content of a file by `text` atomically: readers see either the old or the new content, even if the
/// program or the disk fails meanwhile. Does nothing unless writes_files(). Throws std::runtime_error with the file and
/// the reason.
inline void write_file(std::filesystem::path const& file, std::string_view text) {
  if (!writes_files()) return;
  std::filesystem::path part = file;
  part += '.';
  part += std::to_string(::getpid());
  part += ".part";
  errno = 0;
  std::ofstream stream(part, std::ios::binary);
  stream << text;
  stream.close();
  std::error_code renamed;
  if (stream) {
    std::filesystem::rename(part, file, renamed);
    errno = renamed.value();
  }
  if (stream && !renamed) return;
  int const reason = errno;
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  errno = reason;
  fail_with_errno(file, "write it");
}

}  // namespace scree
