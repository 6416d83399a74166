// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "case_file.hpp"
#include "command_line.hpp"
#include "run.hpp"

#include <functional>

namespace scree::app {

namespace detail {

/// A run without its options, which are read into a struct of any type.
struct AnyRun {
  std::filesystem::path output;
  bool quiet = false;
  bool profile = false;
  std::string case_text;
  std::shared_ptr<OutputDirectory const> directory;
  std::shared_ptr<Preview const> preview = {};
};
/// Takes the directory of a run. A checkpoint that the run continues must be complete: it is read here, before anything
/// that takes time, and again by the run.
std::shared_ptr<OutputDirectory const> take_directory(OutputRequest request);

struct AnyCase {
  OptionList const& list;
  void* options;
  void const* standard;
};
/// Returns nothing if the command line only requests text, such as --help.
std::optional<AnyRun> start(CommandLine const& line, AnyCase const& into, Program const& program);

/// Whether a program has the option Program::restart.
bool has_restart(OptionList const& list, Program const& program);
/// After a signal that left a checkpoint, prints the option that continues the run from it.
void note_how_to_continue(int signal, CommandLine const& line, OptionList const& list, Program const& program);

}  // namespace detail

/// Everything before a run: reads the case that a command line names, and takes the output directory. Its results stay
/// until Run::begin(). Returns nothing when there is nothing to run.
/// Throws CaseError or std::runtime_error.
template <class T>
std::optional<Run<T>> start(CommandLine const& line, Schema<T> const& schema, Program const& program) {
  T options = schema.standard();
  auto const run = detail::start(line, {schema.list(), &options, &schema.standard()}, program);
  if (!run) return std::nullopt;
  return Run<T>{std::move(options), run->output,    run->quiet, run->profile,
                run->case_text,     run->directory, {},         run->preview};
}
/// start() with the arguments of main(), without the name of the program. If there is nothing to run, it returns
/// nothing, and `exit_code` is the exit code of main().
template <class T>
std::optional<Run<T>> start(std::vector<std::string> arguments, Schema<T> const& schema, Program const& program,
                            int& exit_code) {
  auto const line = read_command_line(std::move(arguments), program, exit_code);
  if (!line) return std::nullopt;
  return start(*line, schema, program);
}

/// Exit codes of a case program, apart from 0 and those of signals.
enum ExitCode {
  failed = 1,            ///< the run failed
  refused = 2,           ///< an option or the command line was rejected before anything was written
  outside_validity = 3,  ///< the state left the range in which the model is valid; results until then are kept
};

/// The outcome of a run: its exit code, and the message of its exception without a line break at the end; empty if
/// there was none.
struct Outcome {
  int exit_code = 0;  ///< 0 without an exception
  std::string message = {};
};
/// Runs the body and returns its exit code; that of an exception is not 0, and comes with its message.
Outcome outcome_of(std::function<int()> const& body);

/// On the standard error stream.
void print_message(Outcome const& outcome);

/// Runs main's body, prints the message and returns the exit code of its outcome.
int guarded_main(std::function<int()> const& body);

}  // namespace scree::app
