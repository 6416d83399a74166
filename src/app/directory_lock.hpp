// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/io/write_file.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

namespace scree::app {

/// Keeps other runs out of a directory while it lives, by a lock on the file ".lock" in it. The system takes the lock
/// back when the program ends, in whatever way; the file of a killed run does no harm. File systems without locks keep
/// nobody out.
/// Throws std::runtime_error when another run is there, or the directory cannot be written.
class DirectoryLock {
 public:
  explicit DirectoryLock(std::filesystem::path const& directory) : file_(directory / ".lock") {
    do {
      if (number_ >= 0) ::close(number_);
      open();
      if (::flock(number_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) refuse(directory);
    } while (!has_its_name());  // its last owner removed it in between
    auto const process = fmt::format("{}\n", ::getpid());
    if (::ftruncate(number_, 0) != 0 || ::write(number_, process.data(), process.size()) < 0) {
      int const reason = errno;
      release();
      errno = reason;
      fail_with_errno(file_, "write it");
    }
  }
  DirectoryLock(DirectoryLock const&) = delete;
  DirectoryLock& operator=(DirectoryLock const&) = delete;
  ~DirectoryLock() { release(); }

 private:
  void open() {
    number_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (number_ < 0) fail_with_errno(file_, "write it");
  }
  void release() const {
    ::unlink(file_.c_str());
    ::close(number_);
  }
  [[noreturn]] void refuse(std::filesystem::path const& directory) const {
    char process[32] = {};
    auto const size = ::read(number_, process, sizeof(process) - 1);
    ::close(number_);
    std::string const number(process, size > 0 ? static_cast<std::size_t>(size) - 1 : 0);
    throw std::runtime_error(fmt::format("{}: another run{} is writing its results there; give another --output",
                                         directory.string(), number.empty() ? "" : " (process " + number + ")"));
  }
  bool has_its_name() const {
    struct ::stat mine {};
    struct ::stat named {};
    return ::fstat(number_, &mine) == 0 && ::stat(file_.c_str(), &named) == 0 && mine.st_ino == named.st_ino &&
           mine.st_dev == named.st_dev;
  }

  std::filesystem::path file_;
  int number_ = -1;
};

}  // namespace scree::app
