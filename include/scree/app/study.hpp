// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "start.hpp"

#include <functional>
#include <memory>

namespace scree::app::detail {

/// The members of a study: their options, earlier progress and directories, and the table of all members, study.csv.
/// Options are passed as pointers to structs of the program's type. Several threads may call begin() and run() at the
/// same time.
class Study {
 public:
  /// Acquires the directory of the study. Throws CaseError or std::runtime_error.
  Study(CommandLine const& line, OptionList const& list, void const* standard, Program const& program);
  ~Study();

  std::size_t size() const;
  /// Sets the options of a member, which must have their default values before. Errors are recorded for check().
  void read(std::size_t member, void* options);
  /// Reads the earlier progress of a member from its directory. `scratch` is another struct of options with default
  /// values.
  void look(std::size_t member, void const* options, void* scratch);
  /// Throws CaseError with the errors of all members, if there are any.
  void check() const;

  /// Whether an earlier run of a member was completed.
  bool finished(std::size_t member) const;
  /// Acquires the directory of a member and, if it contains a checkpoint, sets the options to continue from there.
  AnyRun begin(std::size_t member, void* options);
  /// Runs a member and records its outcome in the table and in its directory, so that a continued study can skip it.
  void run(std::size_t member, std::function<int()> const& body);
  /// Returns the number of members to run at a time; 0 if the command line does not specify it.
  int workers(bool one_at_a_time) const;
  /// Prints the outcome of the members and returns the exit code of the program.
  int finish(int signal_code) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace scree::app::detail
