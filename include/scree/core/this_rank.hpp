// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

namespace scree {
namespace detail {

inline int& rank_of_this_thread() {
  thread_local int rank = 0;
  return rank;
}

/// A guard that assigns a rank of a case to the current thread during the guard's lifetime.
class OnThisRank {
 public:
  explicit OnThisRank(int rank) : before_(rank_of_this_thread()) { rank_of_this_thread() = rank; }
  OnThisRank(OnThisRank const&) = delete;
  OnThisRank& operator=(OnThisRank const&) = delete;
  ~OnThisRank() { rank_of_this_thread() = before_; }

 private:
  int before_;
};

}  // namespace detail

/// Whether this thread writes the files of its case and prints: true without ranks and on the first rank.
/// run_on_threads() and run_on_mpi() set the rank. Series, tables, checkpoints and Progress objects made on other ranks
/// write nothing, so that all ranks can run the same code.
inline bool writes_files() { return detail::rank_of_this_thread() == 0; }

}  // namespace scree
