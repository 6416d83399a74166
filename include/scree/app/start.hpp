// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/writes_files.hpp"
#include "case_file.hpp"
#include "command_line.hpp"
#include "output_directory.hpp"
#include "preview.hpp"

#include <functional>
#include <type_traits>

namespace scree::app {

namespace detail {
/// Throws CaseError with the message that the material has no particles at this spacing (m).
[[noreturn]] void refuse_empty(double spacing);
}  // namespace detail

/// One run of a case program.
template <class T>
struct Run {
  T options{};
  std::filesystem::path output = {};  ///< the directory of its results
  bool quiet = false;
  bool profile = false;        ///< print the cost of the steps, see print_profile() in profile.hpp
  std::string case_text = {};  ///< the effective case file, for the provenance of other files
  std::shared_ptr<OutputDirectory const> directory = {};  ///< prevents other runs from using `output`
  std::function<void()> meet = {};                        ///< waits for the other ranks of the case, if there are any
  std::shared_ptr<Preview const> preview = {};            ///< set if the run is to show its initial state and stop

  /// Prepares the directory for the results of a solver, see OutputDirectory::begin(), after checking that the solver
  /// can take its next step (Solver::check_start()). Earlier results remain unchanged until all ranks of a case have
  /// reached this point and have thus read what they need from these results. Throws what the step would throw, and
  /// CaseError for a case without particles and without inlets. With --preview, writes the page of the initial state
  /// and throws an exception that ends the program.
  template <class S>
  void begin(S& solver) const {
    auto const check = [&] {
      if (solver.particles_at_start() + solver.turnover().added == 0 && solver.entered().empty())
        detail::refuse_empty(solver.settings().spacing);
      solver.check_start();
      if (meet) meet();
    };
    if constexpr (CanBeShown<S>)
      if (preview) preview->show(solver, check);
    check();
    if (directory && writes_files()) directory->begin(case_text);
  }
};

namespace detail {

/// A run without its options, whose type may be any struct.
struct AnyRun {
  std::filesystem::path output;
  bool quiet = false;
  bool profile = false;
  std::string case_text;
  std::shared_ptr<OutputDirectory const> directory;
  std::shared_ptr<Preview const> preview = {};
};
/// Acquires the output directory of a run. A checkpoint from which the run continues must be complete; it is therefore
/// read here, before anything that takes time, and again by the run.
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
/// Prints the option that continues the run from its checkpoint after a signal.
void note_how_to_continue(int signal, CommandLine const& line, OptionList const& list, Program const& program);

}  // namespace detail

/// Prepares a run: reads the case that a command line names, and acquires the output directory, whose results remain
/// until Run::begin(). Returns nothing if there is nothing to run. Throws CaseError or std::runtime_error.
template <class T>
std::optional<Run<T>> start(CommandLine const& line, Schema<T> const& schema, Program const& program) {
  T options = schema.standard();
  auto const run = detail::start(line, {schema.list(), &options, &schema.standard()}, program);
  if (!run) return std::nullopt;
  return Run<T>{std::move(options), run->output,    run->quiet, run->profile,
                run->case_text,     run->directory, {},         run->preview};
}
/// Prepares a run from the arguments of main(), without the name of the program. If there is nothing to run, returns
/// nothing and sets `exit_code` to the exit code of main().
template <class T>
std::optional<Run<T>> start(std::vector<std::string> arguments, Schema<T> const& schema, Program const& program,
                            int& exit_code) {
  auto const line = read_command_line(std::move(arguments), program, exit_code);
  if (!line) return std::nullopt;
  return start(*line, schema, program);
}

/// Exit codes of a case program, apart from 0 and the codes after signals.
enum ExitCode {
  failed = 1,            ///< the run failed
  refused = 2,           ///< an option or the command line was rejected before anything was written
  outside_validity = 3,  ///< the state left the range in which the model is valid; results until then are kept
};

/// The outcome of a run: its exit code, and the message of its exception without a final line break (empty: none).
struct Outcome {
  int exit_code = 0;  ///< 0 without an exception
  std::string message = {};
};
/// Runs the body and returns its exit code or, after an exception other than PreviewWritten, a code other than 0 and
/// the message.
Outcome outcome_of(std::function<int()> const& body);

/// Prints the message of an outcome, if there is one, on the standard error stream.
void print_message(Outcome const& outcome);

/// Runs the body of main(), prints the message of its outcome and returns the exit code.
int guarded_main(std::function<int()> const& body);

}  // namespace scree::app
