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

/// Makes the file system reserve blocks, so that an existing file can grow by `bytes`.
///
/// A write that runs out of space half-way through HDF5's metadata leaves an unreadable file, whereas a failed
/// reservation leaves the file unchanged. This detects a full disk, an exceeded quota and the limit of the shell's
/// `ulimit -f` (which would otherwise end the program by a signal). If the file system cannot reserve blocks, only that
/// limit is checked. HDF5 releases the blocks that it does not use. Throws std::system_error with the reason.
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
    if (::ftruncate(descriptor.number, status.st_size) != 0) stop(errno);  // releases a partial reservation
    stop(reason);
  }
#endif
}

}  // namespace scree
