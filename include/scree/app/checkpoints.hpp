// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../io/csv_series.hpp"
#include "../run/checkpoint_policy.hpp"
#include "start.hpp"

#include <functional>
#include <string>
#include <vector>

namespace scree::app {

/// Returns the description of the option that names the checkpoint to start from. The option is a std::string and empty
/// by default. `--study` and the message after a signal find it by its name (see Program::restart):
///     .add("restart_from", &Output::restart_from, app::about_restart())
About about_restart();
/// Returns the description of the option for the wall time (s) between two checkpoints, which is a double:
///     .add("checkpoints", &Output::checkpoints, app::about_checkpoints())
About about_checkpoints();

/// The description of a table that a run writes row by row.
struct Table {
  std::string file;                ///< name of the file in the output directory
  std::vector<CsvColumn> columns;  ///< the first column is the time
  double unit = 1;                 ///< unit of the times in the table, s
};

/// The checkpoints of a run of a case program, in `checkpoint.h5` of its output directory. They are written at
/// intervals of wall time, after a signal, and when save() is called at the end. A run that starts from a checkpoint
/// continues the tables and frames in the directory of that checkpoint, bit for bit as if it had never been stopped.
///
///     app::Checkpoints checkpoints(run, o.output.checkpoints, o.output.restart_from);
///     checkpoints.keep("mass", [&] { return std::vector{mass}; }, [&](auto const& kept) { mass = kept.at(0); });
///     app::Table const history{"history.csv", {{"time", "s"}, {"mass", "kg"}}};
///     checkpoints.restore(solver, duration, {history});
///     run.begin(solver);
///     auto rows = checkpoints.open(history);
///     auto frames = checkpoints.frames<BodySeries<Fields<Velocity>>>();
///     run_with(solver, duration, observers, progress, checkpoints);
///     checkpoints.save(solver.snapshot());
///     return checkpoints.exit_code();
///
/// The HDF5 code of this class is in the library scree::app, so that simulations compile faster.
class Checkpoints : public CheckpointPolicy {
 public:
  using Numbers = std::vector<double>;

  /// Creates the checkpoints of a run, with `interval` seconds of wall time between two of them. `from` is the
  /// checkpoint from which the run starts; empty: none. Throws as CheckpointPolicy does.
  template <class T>
  Checkpoints(Run<T> const& run, double interval, std::filesystem::path from = {})
      : Checkpoints(options_of(run.output, run.case_text, interval), std::move(from)) {}
  /// Creates checkpoints with other options. Tables and frames are in the directory of the checkpoint file.
  explicit Checkpoints(CheckpointOptions options, std::filesystem::path from = {});
  ~Checkpoints();

  using CheckpointPolicy::keep;
  /// Stores numbers of the program in each checkpoint; `take` receives them from the checkpoint that restore() reads.
  /// Throws std::logic_error after restore(), which would have missed the numbers.
  void keep(std::string const& name, std::function<Numbers()> numbers, std::function<void(Numbers const&)> take);

  /// Whether the run starts from a checkpoint.
  bool restarts() const { return !from_.empty(); }
  /// Restores the state of the solver and the stored numbers of the program from the checkpoint to start from, and
  /// prints how the case has changed since. Does nothing if there is no such checkpoint. Throws std::runtime_error if
  /// the checkpoint cannot be read or belongs to another case, if `end` (s) is before the time of the checkpoint, or if
  /// one of the tables or the frames (empty: none) cannot be continued.
  template <class S>
  void restore(S& solver, double end, std::vector<Table> const& tables = {},
               std::string const& frames = "particles.vtkhdf") {
    if (!restarts()) return;
    restored_ = true;
    Snapshot const snapshot = read(from_, print);
    solver.restore(snapshot);
    take(snapshot, end, tables, frames);
  }

  /// Returns a table, with its rows up to the time of the checkpoint that the run starts from. Call this after
  /// Run::begin().
  CsvSeries open(Table const& table) const;
  /// Returns a series of frames in single precision, with the notes of the checkpoints and the frames up to the time of
  /// the checkpoint that the run starts from. `Series` is a BodySeries. Call this after Run::begin().
  template <class Series>
  Series frames(std::string const& file = "particles.vtkhdf") const {
    if (!restarts())
      return Series(output_ / file, {}, {}, {.single_precision = true, .provenance = {notes_.begin(), notes_.end()}});
    return Series::continued(before() / file, time_, output_ / file,
                             {.single_precision = true, .provenance = {notes_.begin(), notes_.end()}});
  }
  /// Returns the directory of the checkpoint that the run starts from.
  std::filesystem::path before() const { return from_.parent_path(); }

 private:
  static CheckpointOptions options_of(std::filesystem::path const& output, std::string const& case_text,
                                      double interval);
  static void print(std::string const& note);
  void take(Snapshot const& snapshot, double end, std::vector<Table> const& tables, std::string const& frames);

  std::filesystem::path output_, from_;
  Notes notes_;
  std::map<std::string, std::function<void(Numbers const&)>> take_;
  double time_ = 0;  // time of the checkpoint, s
  bool restored_ = false;
};

}  // namespace scree::app
