// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "checkpoint_checksum.hpp"
#include "hdf5.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

// The seal of a checkpoint: HDF5 reserves the first 512 bytes of a file (the "user block") for the program, which
// stores the size of the file and the checksum of the remainder there. HDF5's own checksum (Fletcher-32) covers only
// the values of datasets, neither attributes nor metadata. The seal is also checked before HDF5 reads the file, which
// may be damaged.
namespace scree::detail {

inline constexpr std::size_t seal_size = 512;
inline constexpr int checkpoint_format = 1;

/// The owner of a file descriptor. Its functions throw std::system_error if they fail.
class FileDescriptor {
 public:
  FileDescriptor(std::filesystem::path const& path, int flags)
      : number_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
    if (number_ < 0) throw std::system_error(errno, std::generic_category());
  }
  FileDescriptor(FileDescriptor const&) = delete;
  FileDescriptor& operator=(FileDescriptor const&) = delete;
  ~FileDescriptor() { ::close(number_); }

  std::uint64_t size() const {
    struct ::stat status {};
    check(::fstat(number_, &status) == 0);
    return static_cast<std::uint64_t>(status.st_size);
  }
  /// Fills `bytes` with the content of the file after an offset. Returns the number of bytes read.
  std::size_t read(std::span<std::byte> bytes, std::uint64_t from) const {
    std::size_t done = 0;
    while (done < bytes.size()) {
      auto const more = ::pread(number_, bytes.data() + done, bytes.size() - done, static_cast<::off_t>(from + done));
      if (more < 0 && errno == EINTR) continue;
      check(more >= 0);
      if (more == 0) break;
      done += static_cast<std::size_t>(more);
    }
    return done;
  }
  void write(std::string const& text, std::uint64_t from) const {
    for (std::size_t done = 0; done < text.size();) {
      auto const more = ::pwrite(number_, text.data() + done, text.size() - done, static_cast<::off_t>(from + done));
      if (more < 0 && errno == EINTR) continue;
      check(more > 0);
      done += static_cast<std::size_t>(more);
    }
  }
  /// Flushes the file to the disk and waits for it. A file system that cannot sync a directory is not an error.
  void sync() const { check(::fsync(number_) == 0 || errno == EINVAL); }

 private:
  static void check(bool good) {
    if (!good) throw std::system_error(errno, std::generic_category());
  }
  int number_;
};

inline std::string seal_text(std::uint64_t size, std::uint64_t checksum) {
  auto text = fmt::format("scree checkpoint {}\nsize {:020}\nCRC-64/XZ {:016x}\n", checkpoint_format, size, checksum);
  text.resize(seal_size);
  return text;
}

/// Returns the checksum of everything after the seal.
inline std::uint64_t checksum_of(FileDescriptor const& file) {
  std::vector<std::byte> buffer(1 << 20);
  Checksum checksum;
  for (std::uint64_t from = seal_size;;) {
    std::size_t const count = file.read(buffer, from);
    checksum.add(std::span<std::byte const>(buffer).first(count));
    from += count;
    if (count < buffer.size()) return checksum.value();
  }
}

/// Writes the seal of a complete file and flushes the file to the disk.
inline void seal(std::filesystem::path const& path) {
  FileDescriptor const file(path, O_RDWR);
  file.write(seal_text(file.size(), checksum_of(file)), 0);
  file.sync();
}

/// Throws hdf5::Failure if the seal of a file is missing or does not match its content, and std::system_error if the
/// file cannot be read.
inline void check_seal(std::filesystem::path const& path) {
  FileDescriptor const file(path, O_RDONLY);
  std::string found(seal_size, '\0');
  found.resize(file.read(std::as_writable_bytes(std::span<char>(found)), 0));
  std::string const mark = "scree checkpoint ";
  if (found.compare(0, mark.size(), mark) != 0)
    throw hdf5::Failure("it is no checkpoint of scree, which begins with '" + mark + "'");
  int format = 0;
  unsigned long long size = 0, checksum = 0;
  int const count =
      std::sscanf(found.c_str(), "scree checkpoint %d\nsize %llu\nCRC-64/XZ %llx\n", &format, &size, &checksum);
  if (count >= 1 && format != checkpoint_format)
    throw hdf5::Failure(fmt::format("it has format {}, this program reads format {}", format, checkpoint_format));
  if (count != 3 || found != seal_text(size, checksum))
    throw hdf5::Failure(fmt::format("it is damaged: its first {} bytes are not as they were written", seal_size));
  if (file.size() != size)
    throw hdf5::Failure(fmt::format("it is damaged: it has {} bytes instead of {}", file.size(), size));
  if (auto const now = checksum_of(file); now != checksum)
    throw hdf5::Failure(fmt::format("it is damaged: its checksum is {:016x} instead of {:016x}", now, checksum));
}

}  // namespace scree::detail
