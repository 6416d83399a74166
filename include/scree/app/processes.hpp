// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "command_line.hpp"
#include "ranks.hpp"
#include "start.hpp"
#ifdef SCREE_MPI
#include "../distributed/mpi.hpp"

#include <chrono>
#include <cstdio>
#include <thread>
#endif

namespace scree::app::detail {

/// Throws CaseError for a study.
void refuse_study(CommandLine const& line, int processes);
/// Throws CaseError if mpirun has started more than one process of this program.
void refuse_mpirun();

inline namespace SCREE_CASES {
#ifdef SCREE_MPI
/// The processes that mpirun has started for a program. Only the first process writes to standard output.
class Processes {
 public:
  Processes(int& argc, char**& argv) : mpi_(argc, argv) {
    if (!writes_files() && std::freopen("/dev/null", "w", stdout) == nullptr) std::fclose(stdout);
  }
  void check(CommandLine const& line) const {
    if (MpiProgram::ranks() > 1) refuse_study(line, MpiProgram::ranks());
  }
  /// Prints the message of this process and returns its exit code. A failure ends all processes.
  int end(Outcome const& outcome) const {
    bool const failure = outcome.exit_code > 0 && outcome.exit_code < 128;
    // If all ranks fail, the first one reports it.
    if (failure && !writes_files()) std::this_thread::sleep_for(std::chrono::seconds(1));
    print_message(outcome);
    return mpi_.end(outcome.exit_code);
  }

 private:
  MpiProgram mpi_;
};
#else
/// The only process of a program.
struct Processes {
  Processes(int&, char**&) {}
  void check(CommandLine const&) const { refuse_mpirun(); }
  int end(Outcome const& outcome) const {
    print_message(outcome);
    return outcome.exit_code;
  }
};
#endif
}  // namespace SCREE_CASES

}  // namespace scree::app::detail
