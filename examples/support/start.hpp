// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "case_file.hpp"
#include "command_line.hpp"
#include "output_directory.hpp"
#include "run.hpp"

#include <cstdio>
#include <exception>

namespace support {

struct Example {
  std::string name, summary;
  std::vector<std::string> results;  ///< the files it writes, besides case.toml
};

/// Everything before a run: reads the command line and the case, prepares the output directory and writes case.toml,
/// the options in force, into it. Returns nothing when there is nothing to run; then exit_code is main()'s.
/// Throws CaseError or std::runtime_error.
template <class T>
std::optional<Run<T>> start(std::vector<std::string> arguments, Schema<T> const& schema, Example const& example,
                            int& exit_code) {
  auto const line = read_command_line(std::move(arguments), {example.name, example.summary}, exit_code);
  if (!line) return std::nullopt;
  if (line->options) {
    fmt::print("{}", option_table(schema));
    return std::nullopt;
  }
  auto const found = read_case(schema, line->case_file, line->overrides);
  for (auto const& note : found.notes) fmt::print(stderr, "note: {}\n", note);

  auto results = example.results;
  results.emplace_back("case.toml");
  prepare_output({.directory = line->output, .results = results, .force = line->force});
  auto const text = case_text(schema, found.options);
  write_file(line->output / "case.toml", text);
  return Run<T>{.options = found.options, .output = line->output, .quiet = line->quiet, .case_text = text};
}

/// Runs main's body and turns what it throws into one message and an exit code other than 0.
template <class Body>
int guarded_main(Body body) {
  try {
    return body();
  } catch (CaseError const& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  } catch (std::exception const& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 1;
  }
}

}  // namespace support
