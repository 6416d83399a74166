// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace scree::app {

/// The description of a case program for --help and for the directory of its results.
struct Program {
  std::string name;                       ///< "shear_box"
  std::string summary;                    ///< one line for --help
  std::vector<std::string> results = {};  ///< the files that it writes, apart from case.toml and checkpoints
  std::string restart = {};  ///< key of the option for the checkpoint to start from; empty: the one named restart_from
  bool profiles = false;     ///< whether the program offers --profile and calls print_profile() (profile.hpp)
};

/// The command line of a case program.
struct CommandLine {
  std::filesystem::path case_file = {};     ///< empty: all defaults
  std::vector<std::string> overrides = {};  ///< "section.key=value", from --set
  std::filesystem::path output = {};
  bool force = false;                  ///< replace earlier results
  bool options = false;                ///< print the table of options instead of running
  bool quiet = false;                  ///< do not print the progress
  bool profile = false;                ///< print the cost of the steps
  bool preview = false;                ///< write a page with the initial state instead of running
  std::filesystem::path study = {};    ///< a file with values of options; empty: none
  std::vector<std::string> vary = {};  ///< "section.key=[value, ...]", from --vary
  int workers = 0;                     ///< members of a study that run at a time; 0: enough to keep the device busy

  /// Whether the command line requests a study of several cases.
  bool is_study() const { return !study.empty() || !vary.empty(); }
};

/// Reads the command line; `--kokkos-...` is left to Kokkos. Returns std::nullopt if help was printed (`exit_code` is
/// 0) or the command line is invalid (`exit_code` is not 0).
std::optional<CommandLine> read_command_line(std::vector<std::string> arguments, Program const& program,
                                             int& exit_code);

}  // namespace scree::app
