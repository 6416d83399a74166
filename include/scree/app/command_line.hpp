// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace scree::app {

/// Description of a case program for --help and for the directory of its results.
struct Program {
  std::string name;                       ///< "shear_box"
  std::string summary;                    ///< one line for --help
  std::vector<std::string> results = {};  ///< the files it writes, apart from case.toml and checkpoints
  std::string restart = {};  ///< key of the option with the checkpoint to start from; empty: the one named restart_from
  bool profiles = false;     ///< offers --profile: it calls print_profile() (profile.hpp)
};

/// The command line of a case program.
struct CommandLine {
  std::filesystem::path case_file = {};     ///< empty: all defaults
  std::vector<std::string> overrides = {};  ///< "section.key=value", from --set
  std::filesystem::path output = {};
  bool force = false;                  ///< write over earlier results
  bool options = false;                ///< print the table of options instead of running
  bool quiet = false;                  ///< no progress
  bool profile = false;                ///< print the cost of the steps
  bool preview = false;                ///< write a page of the start state instead of running
  std::filesystem::path study = {};    ///< a file with values of options; empty: none
  std::vector<std::string> vary = {};  ///< "section.key=[value, ...]", from --vary
  int workers = 0;                     ///< members of a study at a time; 0: enough to keep the device busy

  /// Whether several cases are to be run.
  bool is_study() const { return !study.empty() || !vary.empty(); }
};

/// Reads the command line. `--kokkos-...` is left to Kokkos. Returns nothing when help was printed or the command line
/// is wrong; `exit_code` tells which (0 or not).
std::optional<CommandLine> read_command_line(std::vector<std::string> arguments, Program const& program,
                                             int& exit_code);

}  // namespace scree::app
