// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../snapshots/snapshot.hpp"
#include "command_line.hpp"

#include <concepts>
#include <exception>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace scree::app {

/// An exception that ends a program after it has written its preview, with exit code 0 and without a message.
struct PreviewWritten {};

/// The content of a preview.
struct StartState {
  Snapshot snapshot;                        ///< state before the first step
  double spacing = 0;                       ///< m
  std::optional<std::string> refusal = {};  ///< the message of the failed start checks; empty: all passed
  std::string warning = {};                 ///< warning of the law; empty: none
  double step = 0;                          ///< length of the first step, s; 0: not taken
  std::map<std::string, long> limits = {};  ///< the number of steps that each limit has set
};

/// Whether S is a solver whose state can be shown.
template <class S>
concept CanBeShown = requires(S& solver) {
  { solver.snapshot() } -> std::same_as<Snapshot>;
  { solver.step(1.0) } -> std::convertible_to<double>;
};

/// The preview of a case (`--preview`): a page for the browser, preview.html in the output directory, with the
/// particles before the first step and a report of the start checks. Other files remain unchanged.
class Preview {
 public:
  /// The longest first step, s.
  static constexpr double longest_step = 1;

  /// Throws std::runtime_error if preview.html exists but is not such a page.
  Preview(std::string program, CommandLine const& line);

  /// Calls `check`, takes the first step to determine its length, writes the page and prints the report. Then throws
  /// the exception of the checks or, if they pass, PreviewWritten. A state with values that are not finite is rejected
  /// without a page. All ranks of a case call this together.
  template <class S, class Check>
  [[noreturn]] void show(S& solver, Check const& check) const {
    StartState state{.snapshot = solver.snapshot(), .spacing = solver.settings().spacing};
    try {
      check();
      if constexpr (requires { solver.settings().physics.warning(); })
        if (solver.settings().start_checks) state.warning = solver.settings().physics.warning();
      state.snapshot = solver.snapshot();  // with the results of the passes
      auto const before = solver.limits();
      state.step = solver.step(longest_step);
      state.limits = solver.limits();
      for (auto const& [name, count] : before) state.limits[name] -= count;
    } catch (std::exception const& refusal) {
      state.refusal = refusal.what();
      write(state);
      throw;
    }
    write(state);
    throw PreviewWritten();
  }
  /// Writes the page and prints the report on the first rank of a case. Throws std::runtime_error if the page cannot be
  /// written.
  void write(StartState const& state) const;

  /// Returns the path of the page.
  std::filesystem::path const& file() const { return file_; }

 private:
  std::string title_;
  std::filesystem::path file_;
  bool quiet_ = false;
};

}  // namespace scree::app
