// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "case_file.hpp"
#include "command_line.hpp"
#include "output_directory.hpp"
#include "run.hpp"
#include "say.hpp"

#include <scree/solver/outside_validity.hpp>

#include <exception>
#include <type_traits>

namespace support {

struct Example {
  std::string name, summary;
  std::vector<std::string> results;  ///< the files it writes, besides case.toml
};

/// The checkpoint that options name to start from; empty: none.
template <class T>
using CheckpointOf = std::function<std::filesystem::path(T const&)>;

/// Everything before a run: reads the command line and the case, and takes the output directory. Its results stay until
/// begin_results(). Returns nothing when there is nothing to run; then exit_code is main()'s.
/// Throws CaseError or std::runtime_error.
template <class T>
std::optional<Run<T>> start(std::vector<std::string> arguments, Schema<T> const& schema, Example const& example,
                            int& exit_code, std::type_identity_t<CheckpointOf<T>> const& checkpoint_of = {}) {
  auto const line = read_command_line(std::move(arguments), {example.name, example.summary}, exit_code);
  if (!line) return std::nullopt;
  if (line->options) {
    say(stdout, "{}", option_table(schema));
    return std::nullopt;
  }
  auto const found = read_case(schema, line->case_file, line->overrides);
  for (auto const& note : found.notes) say(stderr, "note: {}\n", printable(note));

  OutputRequest request{.directory = line->output, .results = example.results, .force = line->force};
  if (checkpoint_of) request.continues = checkpoint_of(found.options);
  return Run<T>{.options = found.options,
                .output = line->output,
                .quiet = line->quiet,
                .case_text = case_text(schema, found.options),
                .directory = std::make_shared<OutputDirectory const>(std::move(request))};
}

/// Exit codes other than 0 and those of signals; see README.md of the examples.
enum ExitCode { failed = 1, refused = 2, outside_validity = 3 };

/// Runs main's body and turns what it throws into one message and an exit code other than 0.
template <class Body>
int guarded_main(Body body) {
  try {
    return body();
  } catch (CaseError const& error) {
    say(stderr, "{}\n", error.what());
    return refused;
  } catch (scree::OutsideValidity const& error) {
    say(stderr, "error: {}; results until then are kept\n", printable(error.what()));
    return outside_validity;
  } catch (std::filesystem::filesystem_error const& error) {
    say(stderr, "error: {}: {}\n", printable(error.path1().string()), error.code().message());
    return failed;
  } catch (std::exception const& error) {
    say(stderr, "error: {}\n", printable(error.what()));
    return failed;
  }
}

}  // namespace support
