// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../core/writes_files.hpp"
#include "interrupt.hpp"
#include "snapshot_notes.hpp"
#include "wall_clock.hpp"

#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

// The policy that decides when a run writes checkpoints. It does not depend on HDF5, so that device compilers accept
// it; io/checkpoints.hpp adds the files.
namespace scree {

/// The file and the intervals of the checkpoints of a run.
struct CheckpointOptions {
  std::filesystem::path file;  ///< "output/checkpoint.h5"; its directory must exist
  double interval = 1800;      ///< seconds of wall time between two checkpoints; 0: every step
  double time_interval = std::numeric_limits<double>::infinity();  ///< simulated time between checkpoints, s; above 0
  Notes notes = {};                                ///< stored in each checkpoint: the case as text, the version, ...
  std::function<double()> seconds = wall_seconds;  ///< a clock
};

/// Functions that write and read a checkpoint, as write_checkpoint() and read_checkpoint() do.
struct CheckpointFiles {
  std::function<void(std::filesystem::path const&, Snapshot const&)> write;  ///< replaces the file
  std::function<Snapshot(std::filesystem::path const&)> read;                ///< throws if the file is damaged
};

/// A policy that writes a checkpoint after each interval of wall time or of simulated time, whichever ends first, and
/// when the run is interrupted (see Interrupt). Pass it to run_with(). Each rank of a case has its own policy. If one
/// rank has to write a checkpoint or stop, all ranks do so after the same step.
class CheckpointPolicy {
 public:
  /// Throws std::invalid_argument if an interval is out of range or a file cannot store the notes.
  CheckpointPolicy(CheckpointOptions options, CheckpointFiles files);
  ~CheckpointPolicy();

  /// Returns the snapshot of the checkpoint to start from. Calls `report` with a line for each change of the notes
  /// since the checkpoint was written. Throws std::runtime_error if the file cannot be read.
  Snapshot read(std::filesystem::path const& file, std::function<void(std::string const&)> const& report = {}) const;

  /// Registers a function whose numbers are stored in each checkpoint under a name, for numbers_in(). Throws
  /// std::invalid_argument if a file cannot store the name.
  void keep(std::string const& name, std::function<std::vector<double>()> numbers);

  /// Writes a checkpoint if one is due. Call this after each step, when observers have run. Returns true if the run
  /// should stop because it was interrupted; the checkpoint is then written.
  template <class Solver>
  bool after_step(Solver const& solver) {
    auto const largest = [&](int number) {
      if constexpr (requires { solver.whole_case(); })
        return int(solver.whole_case().largest(number));
      else
        return number;
    };
    int const found = largest(2 * interrupt_.exit_code() + due(solver.time()));  // one message for both
    exit_code_ = found / 2;
    if (found != 0) save(solver.snapshot());
    return exit_code_ != 0;
  }
  /// Whether after_step() would write a checkpoint at a time (s).
  bool due(double time) { return due() || is_reached(time); }
  /// Whether after_step() would write a checkpoint now because of wall time or an interrupt, regardless of the
  /// simulated time.
  bool due() const;
  /// Writes a checkpoint now and keeps the previous one, see write_checkpoint().
  void save(Snapshot snapshot);

  /// Whether an interrupt has stopped the run.
  bool interrupted() const { return exit_code_ != 0; }
  /// Returns the value that main() should return: 0, or the exit code that a shell expects after a signal.
  int exit_code() const { return exit_code_ != 0 ? exit_code_ : interrupt_.exit_code(); }

 private:
  static void require(std::string const& no_fault);
  double next_after(double time) const;
  /// Whether `time` has reached the next multiple of the time interval after the last checkpoint or, before any
  /// checkpoint, after the first call.
  bool is_reached(double time);

  CheckpointOptions options_;
  CheckpointFiles files_;
  std::map<std::string, std::function<std::vector<double>()>> kept_;
  double last_;
  std::optional<double> next_;
  Interrupt interrupt_;
  int exit_code_ = 0;  // of the signal that has stopped all ranks
};

}  // namespace scree

#ifndef SCREE_COMPILED
#include "checkpoint_policy.ipp"
#endif
