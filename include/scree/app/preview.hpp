// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../snapshots/snapshot.hpp"

#include <concepts>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace scree::app {

struct CommandLine;  // command_line.hpp

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

/// The functions of a solver that a preview uses, independent of the formulation.
class ShownStart {
 public:
  virtual ~ShownStart() = default;
  /// Checks the start. Throws what the checks throw.
  virtual void check() = 0;
  /// Returns the state of the solver.
  virtual Snapshot snapshot() const = 0;
  /// Returns the spacing of the particles, m.
  virtual double spacing() const = 0;
  /// Returns the warning of the physics model; empty if there is none.
  virtual std::string warning() const = 0;
  /// Takes a step of at most `longest` (s); returns its length.
  virtual double step(double longest) = 0;
  /// Returns the number of steps that each limit has set.
  virtual std::map<std::string, long> limits() const = 0;
};

namespace detail {
template <class S, class Check>
class ShownSolver : public ShownStart {
 public:
  ShownSolver(S& solver, Check const& check) : solver_(solver), check_(check) {}
  void check() override { check_(); }
  Snapshot snapshot() const override { return solver_.snapshot(); }
  double spacing() const override { return solver_.settings().spacing; }
  std::string warning() const override {
    if constexpr (requires(S const& solver) { solver.settings().physics.warning(); })
      if (solver_.settings().start_checks) return solver_.settings().physics.warning();
    return "";
  }
  double step(double longest) override { return solver_.step(longest); }
  std::map<std::string, long> limits() const override { return solver_.limits(); }

 private:
  S& solver_;
  Check const& check_;
};
}  // namespace detail

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
    detail::ShownSolver<S, Check> start(solver, check);
    show(start);
  }
  /// Writes the page and prints the report on the first rank of a case. Throws std::runtime_error if the page cannot be
  /// written.
  void write(StartState const& state) const;

  /// Returns the path of the page.
  std::filesystem::path const& file() const { return file_; }

 private:
  [[noreturn]] void show(ShownStart& start) const;

  std::string title_;
  std::filesystem::path file_;
  bool quiet_ = false;
};

}  // namespace scree::app
