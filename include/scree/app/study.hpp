// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "start.hpp"

#include <functional>
#include <memory>

namespace scree::app::detail {

/// The members of a study: their options, their earlier progress, their directories, and the table of all, study.csv.
/// Options are given as pointers to structs of the program's type. begin() and run() may be called by several threads.
class Study {
 public:
  /// Takes the directory of the study. Throws CaseError or std::runtime_error.
  Study(CommandLine const& line, OptionList const& list, void const* standard, Program const& program);
  ~Study();

  std::size_t size() const;
  /// Sets the options of a member, which have their defaults before. check() returns the mistakes.
  void read(std::size_t member, void* options);
  /// Finds out the content of the directory of a member. `scratch` is another struct of options with defaults.
  void look(std::size_t member, void const* options, void* scratch);
  /// Throws CaseError naming everything that was wrong with any member.
  void check() const;

  /// Whether a member was run to its end before.
  bool finished(std::size_t member) const;
  /// Takes the directory of a member; sets its options to continue from its checkpoint, if it has one.
  AnyRun begin(std::size_t member, void* options);
  /// Runs a member and records its outcome in the table, so that a study that is continued can skip it.
  void run(std::size_t member, std::function<int()> const& body);
  /// The number of members to run at a time, 0 if the command line leaves it open.
  int workers(bool one_at_a_time) const;
  /// Prints the outcome of the members. Returns the exit code of the program.
  int finish(int signal_code) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace scree::app::detail
