// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/writes_files.hpp"

#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>

namespace scree {

/// A file that is complete at any time, even if the program is killed while it writes. Each change is first made to a
/// second copy, "FILE.part"; then the two copies exchange names, and the change is repeated. This takes twice the disk
/// space and twice the writing. The destructor removes the second copy. Does nothing unless writes_files().
class TwinFile {
 public:
  /// Takes the path of a file that does not exist yet or will be replaced.
  explicit TwinFile(std::filesystem::path file) : file_(std::move(file)), twin_(file_), old_(file_) {
    twin_ += ".part";
    old_ += ".old";
  }
  TwinFile(TwinFile const&) = delete;
  TwinFile& operator=(TwinFile const&) = delete;
  ~TwinFile() {
    if (!writes_) return;
    std::error_code ignored;
    std::filesystem::remove(twin_, ignored);
    std::filesystem::remove(old_, ignored);
  }

  /// Returns the path of the file, not of its second copy.
  std::filesystem::path const& file() const { return file_; }

  /// Replaces the file by a copy of another file (or of itself), changed by `change(path)`.
  template <class Change>
  void begin_from(std::filesystem::path const& source, Change const& change) {
    if (!writes_) return;
    equal_ = false;
    std::filesystem::copy_file(source, twin_, std::filesystem::copy_options::overwrite_existing);
    change(twin_);
    std::filesystem::rename(twin_, file_);
  }
  /// Calls `change(path)` for both copies, one after the other. If the first call throws, the file is unchanged; if the
  /// second call throws, the second copy is made anew at the next change.
  template <class Change>
  void change(Change const& change) {
    if (!writes_) return;
    if (!equal_) std::filesystem::copy_file(file_, twin_, std::filesystem::copy_options::overwrite_existing);
    equal_ = false;
    change(twin_);
    exchange();
    try {
      change(twin_);
      equal_ = true;
    } catch (std::exception const&) {
    }
  }

 private:
  /// Exchanges the names of the two copies. A hard link keeps the file under a second name meanwhile, so that its own
  /// name never disappears; on a file system without hard links, the file is renamed.
  void exchange() const {
    std::error_code without_links;
    std::filesystem::remove(old_);  // left by a program that was killed here
    std::filesystem::create_hard_link(file_, old_, without_links);
    if (without_links) std::filesystem::rename(file_, old_);
    std::filesystem::rename(twin_, file_);
    std::filesystem::rename(old_, twin_);
  }

  std::filesystem::path file_, twin_, old_;
  bool equal_ = false;
  bool const writes_ = writes_files();
};

}  // namespace scree
