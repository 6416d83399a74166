// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "case_file.hpp"
#include "command_line.hpp"
#include "output_directory.hpp"

#include <functional>
#include <type_traits>

namespace scree::app {

/// One run of a case program.
template <class T>
struct Run {
  T options{};
  std::filesystem::path output = {};  ///< the directory of its results
  bool quiet = false;
  std::string case_text = {};  ///< the effective case file, for the provenance of other files
  std::shared_ptr<OutputDirectory const> directory = {};  ///< keeps other runs out of `output`

  /// Makes the directory ready for the results, see OutputDirectory::begin(). Until then earlier results stay.
  void begin() const {
    if (directory) directory->begin(case_text);
  }
};

/// The checkpoint that options name to start from; empty: none.
template <class T>
using CheckpointOf = std::function<std::filesystem::path(T const&)>;

namespace detail {

/// A run without its options, which are read into a struct of any type.
struct AnyRun {
  std::filesystem::path output;
  bool quiet = false;
  std::string case_text;
  std::shared_ptr<OutputDirectory const> directory;
};
struct AnyCase {
  OptionList const& list;
  void* options;
  void const* standard;
};
std::optional<AnyRun> start(std::vector<std::string> arguments, AnyCase const& into, Program const& program,
                            int& exit_code, std::function<std::filesystem::path()> const& checkpoint);

}  // namespace detail

/// Everything before a run: reads the command line and the case, and takes the output directory. Its results stay until
/// Run::begin(). Returns nothing when there is nothing to run; then exit_code is main()'s.
/// Throws CaseError or std::runtime_error.
template <class T>
std::optional<Run<T>> start(std::vector<std::string> arguments, Schema<T> const& schema, Program const& program,
                            int& exit_code, std::type_identity_t<CheckpointOf<T>> const& checkpoint_of = {}) {
  T options = schema.standard();
  auto const checkpoint = [&] { return checkpoint_of ? checkpoint_of(options) : std::filesystem::path(); };
  auto const run = detail::start(std::move(arguments), {schema.list(), &options, &schema.standard()}, program,
                                 exit_code, checkpoint);
  if (!run) return std::nullopt;
  return Run<T>{std::move(options), run->output, run->quiet, run->case_text, run->directory};
}

/// Exit codes other than 0 and those of signals.
enum ExitCode {
  failed = 1,            ///< the run failed
  refused = 2,           ///< an option or the command line was rejected before anything was written
  outside_validity = 3,  ///< the state left the range in which the model is valid; results until then are kept
};

/// Runs main's body and turns what it throws into one message and an exit code other than 0.
int guarded_main(std::function<int()> const& body);

}  // namespace scree::app
