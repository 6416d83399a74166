// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

namespace scree {
namespace detail {

inline int& part_of_this_thread() {
  thread_local int part = 0;
  return part;
}

/// While it lives, this thread works on a part of a case.
class OnThisPart {
 public:
  explicit OnThisPart(int part) : before_(part_of_this_thread()) { part_of_this_thread() = part; }
  OnThisPart(OnThisPart const&) = delete;
  OnThisPart& operator=(OnThisPart const&) = delete;
  ~OnThisPart() { part_of_this_thread() = before_; }

 private:
  int before_;
};

}  // namespace detail

/// Whether this thread writes the files of its case and prints: true without parts, and on the first part
/// (run_on_parts() and run_on_ranks() set it). Series, tables, checkpoints and Progress made on other parts write
/// nothing, so that all parts can run the same code.
inline bool writes_files() { return detail::part_of_this_thread() == 0; }

}  // namespace scree
