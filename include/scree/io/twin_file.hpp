// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/writes_files.hpp"

#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>

namespace scree {

/// A file that is whole at any time, also when the program is killed while it writes: changes go to a second copy,
/// "FILE.part", first; then the two exchange names, and the change is repeated. It costs twice the disk and twice the
/// writing; the copy is removed at the end. Does nothing unless writes_files().
class TwinFile {
 public:
  /// A file that does not exist yet or will be replaced.
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

  /// The file, without the second copy.
  std::filesystem::path const& file() const { return file_; }

  /// Begins with a copy of another file (or of this one), changed by `change(path)`.
  template <class Change>
  void begin_from(std::filesystem::path const& source, Change const& change) {
    if (!writes_) return;
    equal_ = false;
    std::filesystem::copy_file(source, twin_, std::filesystem::copy_options::overwrite_existing);
    change(twin_);
    std::filesystem::rename(twin_, file_);
  }
  /// Calls `change(path)` for both copies, one after the other. Where it throws for the first, the file is as before;
  /// where the second fails, it is copied at the next change.
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
  /// By a second name for the file, so that at no time it is without one; where there are no hard links, by another.
  void exchange() const {
    std::error_code without_links;
    std::filesystem::remove(old_);  // of a program that was killed here
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
