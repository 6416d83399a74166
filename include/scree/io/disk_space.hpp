// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <filesystem>
#include <system_error>

#if defined(__linux__)
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#endif

namespace scree {

/// Makes sure that an existing file can grow by `bytes`, by letting the file system set the blocks aside.
///
/// A write that runs out of space half-way through HDF5's metadata leaves an unreadable file; reserving the space
/// beforehand leaves the file unchanged if it fails. Covers a full disk, quotas and the shell's `ulimit -f` (which
/// would otherwise end the program by a signal). Where the file system cannot reserve, nothing is checked. HDF5 trims
/// what it does not use. Throws std::system_error with the reason.
inline void reserve_disk_space([[maybe_unused]] std::filesystem::path const& file,
                               [[maybe_unused]] std::uintmax_t bytes) {
#if defined(__linux__)
  struct Descriptor {
    int number;
    ~Descriptor() {
      if (number >= 0) ::close(number);
    }
  };
  auto const stop = [](int reason) { throw std::system_error(reason, std::generic_category()); };

  Descriptor const descriptor{::open(file.c_str(), O_RDWR | O_CLOEXEC)};
  struct ::stat status {};
  if (descriptor.number < 0 || ::fstat(descriptor.number, &status) != 0) stop(errno);
  ::rlimit limit{};
  bool const limited = ::getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  if (limited && static_cast<std::uintmax_t>(status.st_size) + bytes > limit.rlim_cur) stop(EFBIG);

  if (::fallocate(descriptor.number, 0, status.st_size, static_cast<::off_t>(bytes)) != 0) {
    int const reason = errno;
    if (reason == EOPNOTSUPP || reason == ENOSYS) return;
    if (::ftruncate(descriptor.number, status.st_size) != 0) stop(errno);  // gives a partial reservation back
    stop(reason);
  }
#endif
}

}  // namespace scree
