// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "interrupt.hpp"

#include <scree/solver/snapshot.hpp>

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

// Checkpoints of an example. Nothing here knows of HDF5, so that a compiler for devices may see it.
namespace support {

/// scree::write_checkpoint() and scree::read_checkpoint(), in checkpoints.cpp.
void write_checkpoint(std::filesystem::path const& file, scree::Snapshot const& snapshot);
scree::Snapshot read_checkpoint(std::filesystem::path const& file);

/// Numbers that a snapshot holds under a name in addition to the state of the particles; none where the name is
/// missing.
void add_numbers(scree::Snapshot& snapshot, std::string const& name, std::vector<double> const& numbers);
std::vector<double> numbers_in(scree::Snapshot const& snapshot, std::string const& name);

/// What differs between the notes of a checkpoint and those of a run, line by line, in words: "case: 'spacing = 0.04'
/// of the checkpoint is missing", "case: 'spacing = 0.05' is new". Comments (#) and blank lines do not count.
std::vector<std::string> changes(std::map<std::string, std::string> const& checkpoint,
                                 std::map<std::string, std::string> const& run);

/// "note: ..." on the standard error stream.
void print_note(std::string const& note);

struct CheckpointOptions {
  std::filesystem::path file;                ///< "output/checkpoint.h5"
  double interval = 1800;                    ///< s of the clock on the wall between two checkpoints; 0: every step
  std::map<std::string, std::string> notes;  ///< kept in each: the case as text, the version, ...
  std::function<double()> seconds = [] {     ///< a clock
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  };
};

/// Writes a checkpoint now and then, and when the run is interrupted.
///
///     Checkpoints checkpoints({.file = run.output / "checkpoint.h5", .notes = {{"case", run.case_text}}});
///     if (resume) solver.restore(checkpoints.read(resume_from, report));
///     solver.run(
///         end, observers, [&](auto const& s) { return checkpoints.after_step(s); }, [&] { return checkpoints.due();
///         });
///     return checkpoints.exit_code();
class Checkpoints {
 public:
  explicit Checkpoints(CheckpointOptions options) : options_(std::move(options)), last_(options_.seconds()) {}

  /// Reads the checkpoint to start from, and reports each change of the notes since.
  scree::Snapshot read(std::filesystem::path const& file,
                       std::function<void(std::string const&)> const& report = {}) const {
    auto snapshot = read_checkpoint(file);
    if (report)
      for (auto const& change : changes(snapshot.notes, options_.notes)) report(file.string() + ": " + change);
    return snapshot;
  }

  /// Keeps in each checkpoint what `numbers` returns then, for numbers_in().
  void keep(std::string const& name, std::function<std::vector<double>()> numbers) { kept_[name] = std::move(numbers); }

  /// To be called after each step, when observers have seen it. Returns true when the run shall stop: a checkpoint is
  /// written then.
  template <class Solver>
  bool after_step(Solver const& solver) {
    bool const stop = interrupt_.requested();
    if (due()) save(solver.snapshot());
    return stop;
  }
  /// Whether after_step() has anything to do.
  bool due() const { return interrupt_.requested() || options_.seconds() - last_ >= options_.interval; }
  /// Writes a checkpoint now.
  void save(scree::Snapshot snapshot) {
    snapshot.notes = options_.notes;
    for (auto const& [name, numbers] : kept_) add_numbers(snapshot, name, numbers());
    write_checkpoint(options_.file, snapshot);
    last_ = options_.seconds();  // so that slow disks do not stop a run altogether
  }

  bool interrupted() const { return interrupt_.requested(); }
  /// What main() returns: 0, or what a shell expects after a signal.
  int exit_code() const { return interrupt_.exit_code(); }

 private:
  CheckpointOptions options_;
  std::map<std::string, std::function<std::vector<double>()>> kept_;
  double last_;
  Interrupt interrupt_;
};

}  // namespace support
