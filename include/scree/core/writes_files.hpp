// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

namespace scree {
namespace detail {

inline bool& this_thread_writes_files() {
  thread_local bool writes = true;
  return writes;
}

/// A guard that determines whether the current thread writes files during the guard's lifetime.
class LetWriteFiles {
 public:
  explicit LetWriteFiles(bool writes) : before_(this_thread_writes_files()) { this_thread_writes_files() = writes; }
  LetWriteFiles(LetWriteFiles const&) = delete;
  LetWriteFiles& operator=(LetWriteFiles const&) = delete;
  ~LetWriteFiles() { this_thread_writes_files() = before_; }

 private:
  bool before_;
};

}  // namespace detail

/// Whether this thread writes the files of its case and prints: true without ranks and on the first rank.
/// run_on_threads() and run_on_mpi() set the value. Series, tables, checkpoints and Progress objects made on other
/// ranks write nothing, so that all ranks can run the same code.
inline bool writes_files() { return detail::this_thread_writes_files(); }

}  // namespace scree
